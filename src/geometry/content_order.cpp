#include "geometry/content_order.h"

#include <cstring>
#include <type_traits>

namespace lapidary::geometry {
namespace {

/// Plain structs of doubles, by their bits.
template <typename Kind>
int compare(const Kind& a, const Kind& b) {
  static_assert(std::is_trivially_copyable_v<Kind> && sizeof(Kind) % sizeof(double) == 0);
  return std::memcmp(&a, &b, sizeof(Kind));
}

int compare(const Solid& a, const Solid& b) {
  if (a.index() != b.index()) return a.index() < b.index() ? -1 : 1;
  return std::visit(
      [&](const auto& kind) { return compare(kind, std::get<std::decay_t<decltype(kind)>>(b)); },
      a);
}

int compare(const Transform& a, const Transform& b) {
  const Vec3d offset_a = a.offset(), offset_b = b.offset();
  const int linear = std::memcmp(&a.linear(), &b.linear(), sizeof(Mat3));
  return linear != 0 ? linear : std::memcmp(&offset_a, &offset_b, sizeof(Vec3d));
}

}  // namespace

bool content_less(const PlacedSolid& a, const PlacedSolid& b) {
  const int shape = compare(a.shape(), b.shape());
  if (shape != 0) return shape < 0;
  return compare(a.world_from_solid(), b.world_from_solid()) < 0;
}

}  // namespace lapidary::geometry
