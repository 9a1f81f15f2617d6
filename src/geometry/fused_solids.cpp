#include "geometry/fused_solids.h"

#include <functional>
#include <string_view>

namespace lapidary::geometry {
namespace {

class PlaneHash {
 public:
  void add(const HalfSpace& plane) {
    static_assert(sizeof(HalfSpace) == 6 * sizeof(double));
    const std::string_view bytes(reinterpret_cast<const char*>(&plane), sizeof(plane));
    value_ = value_ * 31 + std::hash<std::string_view>{}(bytes);
  }
  std::size_t value() const { return value_; }

 private:
  std::size_t value_ = 0;
};

}  // namespace

void FusedSolids::add(const PlacedSolid& fused) {
  const auto& shape = std::get<Polyhedron>(fused.shape());
  PlaneHash hash;
  for (Patch face = 0; face < shape.face_count(); ++face) hash.add(shape.face(face));
  by_planes_.emplace(hash.value(), fused);
}

const PlacedSolid* FusedSolids::find(std::span<const PlacedSolid> half_spaces) const {
  if (by_planes_.empty()) return nullptr;
  PlaneHash hash;
  for (const PlacedSolid& h : half_spaces) hash.add(std::get<HalfSpace>(h.shape()));
  const auto [first, last] = by_planes_.equal_range(hash.value());
  for (auto at = first; at != last; ++at) {
    if (at->second.is_fused_of(half_spaces)) return &at->second;
  }
  return nullptr;
}

}  // namespace lapidary::geometry
