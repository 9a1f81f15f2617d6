#include "geometry/content_order.h"

#include <cstring>
#include <type_traits>

#include "math/same_bits.h"

namespace lapidary::geometry {
namespace {

/// Bodies of many faces, by what they are made of.
int compare(const MeshBody& a, const MeshBody& b) {
  const TriangleMesh &p = a.mesh(), &q = b.mesh();
  if (&p == &q) return 0;
  const auto order = [](const auto& x, const auto& y) {
    if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
    return x.empty() ? 0 : std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0]));
  };
  const int origin = std::memcmp(&p.origin, &q.origin, sizeof(Vec3d));
  if (origin != 0) return origin;
  const int positions = order(p.positions, q.positions);
  return positions != 0 ? positions : order(p.triangles, q.triangles);
}

int compare(const Polyhedron& a, const Polyhedron& b) {
  const std::size_t n = a.face_count();
  if (n != b.face_count()) return n < b.face_count() ? -1 : 1;
  for (std::size_t i = 0; i < n; ++i) {
    const HalfSpace p = a.face(static_cast<Patch>(i)), q = b.face(static_cast<Patch>(i));
    const int order = std::memcmp(&p, &q, sizeof(HalfSpace));
    if (order != 0) return order;
  }
  return 0;
}

int compare(const Quadric& a, const Quadric& b) {
  static_assert(sizeof(QuadraticForm) == 10 * sizeof(double));
  return std::memcmp(a.form.get(), b.form.get(), sizeof(QuadraticForm));
}

int compare(const Prism& a, const Prism& b) {
  return compare_content(a, b);
}

int compare(const Lathe& a, const Lathe& b) {
  return compare_content(a, b);
}

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

/// Where the order of content does not tell all.
template <typename Kind>
bool is_same(const Kind& a, const Kind& b) {
  return compare(a, b) == 0;
}

bool is_same(const MeshBody& a, const MeshBody& b) {
  return is_same_surface(a.mesh(), b.mesh());
}

bool is_same(const Polyhedron& a, const Polyhedron& b) {
  return has_same_content(a, b);
}

bool is_same(const Solid& a, const Solid& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& kind) { return is_same(kind, std::get<std::decay_t<decltype(kind)>>(b)); },
      a);
}

int compare(const Transform& a, const Transform& b) {
  const Vec3d offset_a = a.offset(), offset_b = b.offset();
  const int linear = std::memcmp(&a.linear(), &b.linear(), sizeof(Mat3));
  return linear != 0 ? linear : std::memcmp(&offset_a, &offset_b, sizeof(Vec3d));
}

}  // namespace

bool is_same(const PlacedSolid& a, const PlacedSolid& b) {
  if (a.space() != b.space() || !is_same(a.shape(), b.shape())) return false;
  if (!a.has_same_errors(b)) return false;
  const OwnSpace *p = a.own_space(), *q = b.own_space();
  if (p == q) return true;
  if (p == nullptr || q == nullptr || !is_same(a.solid(), b.solid())) return false;
  // With its inverse, which is not always what one would compute of it.
  static_assert(sizeof(Transform) == 2 * (sizeof(Mat3) + sizeof(Vec3d)));
  return same_bits(p->world_from_own(), q->world_from_own());
}

bool content_less(const PlacedSolid& a, const PlacedSolid& b) {
  const int shape = compare(a.shape(), b.shape());
  if (shape != 0) return shape < 0;
  return compare(a.world_from_solid(), b.world_from_solid()) < 0;
}

bool placement_less(const PlacedSolid& a, const PlacedSolid& b) {
  return compare(a.world_from_solid(), b.world_from_solid()) < 0;
}

}  // namespace lapidary::geometry
