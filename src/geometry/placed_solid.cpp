#include "geometry/placed_solid.h"

#include "geometry/affine_area.h"
#include "geometry/affine_error.h"
#include "geometry/curved_placement.h"
#include "geometry/rounded_bounds.h"
#include "math/frame.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// Bounds on how far the surface of `image`, computed in doubles, is from the exact image of
/// `solid` under `map`.
double image_error(const Sphere& solid, const Sphere& image, const Transform& map) {
  const double scale = image.radius / solid.radius;
  return point_error(map, solid.center) +
         image.radius * (similarity_deviation(map.linear(), scale) + 4 * u_);
}
double image_error(const Box& solid, const Box&, const Transform& map) {
  return point_error(map, solid.min) + point_error(map, solid.max);
}
double image_error(const HalfSpace& solid, const HalfSpace&, const Transform& map) {
  return point_error(map, solid.point);
}
double image_error(const Cylinder& solid, const Cylinder& image, const Transform& map) {
  const double ends = point_error(map, solid.from) + point_error(map, solid.to);
  const double height = length(image.to - image.from);
  const double scale = image.radius / solid.radius;
  return ends * (1 + 2 * image.radius / height) +
         3 * (similarity_deviation(map.linear(), scale) + 4 * u_) * (image.radius + height);
}

Box3d affine_bounds(const Sphere& sphere, const Transform& map) {
  const Vec3d center = map.point(sphere.center);
  const Mat3& m = map.linear();
  const Vec3d half = Vec3d{length(m.row[0]), length(m.row[1]), length(m.row[2])} * sphere.radius;
  return {center - half, center + half};
}
Box3d affine_bounds(const Box& box, const Transform& map) {
  return map.box(bounds(box));
}
Box3d affine_bounds(const HalfSpace&, const Transform&) {
  return Box3d::all();
}
Box3d affine_bounds(const Cylinder& cylinder, const Transform& map) {
  const Vec3d from = map.point(cylinder.from), to = map.point(cylinder.to);
  const Vec3d axis = normalize(cylinder.to - cylinder.from);
  Vec3d half;
  for (std::size_t i = 0; i < 3; ++i) {
    half[i] = cylinder.radius * length(cross(map.linear().row[i], axis));
  }
  return {min(from, to) - half, max(from, to) + half};
}

double affine_area(const Sphere& sphere, const Mat3& linear) {
  return sphere.radius * sphere.radius * ellipsoid_area(linear);
}
double affine_area(const Box& box, const Mat3& linear) {
  const Mat3 c = cofactors(linear);
  const Vec3d e = box.max - box.min;
  return 2.0 * (e.y * e.z * length(c.column(0)) + e.z * e.x * length(c.column(1)) +
                e.x * e.y * length(c.column(2)));
}
double affine_area(const HalfSpace&, const Mat3&) {
  return infinity;
}
double affine_area(const Cylinder& cylinder, const Mat3& linear) {
  const Mat3 c = cofactors(linear);
  const Vec3d a = cylinder.to - cylinder.from;
  const double height = length(a), r = cylinder.radius;
  const Frame frame = Frame::from_normal(a / height);
  return 2.0 * pi * r * r * length(c * frame.normal) +
         r * height * ellipse_perimeter(c * frame.tangent, c * frame.bitangent);
}

}  // namespace

PlacedSolid::PlacedSolid(const Solid& solid, const Transform& world_from_solid)
    : space_(Space::own),
      shape_(solid),
      offset_(world_from_solid.offset()),
      own_from_world_(world_from_solid.inverse().linear()),
      gain_(frobenius_norm(own_from_world_) * (1 + 8 * u_)),
      solid_(solid),
      world_from_solid_(world_from_solid) {
  mapping_error_ = frobenius_norm(inverse_error(own_from_world_, world_from_solid.linear()));
  if (const auto image = transformed(solid, world_from_solid)) set_baked(*image);
}

void PlacedSolid::set_baked(const Solid& image) {
  space_ = Space::world;
  shape_ = image;
  if (world_from_solid_.is_identity()) return;
  surface_error_ = std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        return image_error(kind, std::get<Kind>(image), world_from_solid_);
      },
      solid_);
  if (const auto* half_space = std::get_if<HalfSpace>(&image)) {
    const auto& own = std::get<HalfSpace>(solid_);
    const Mat3 e = transpose(inverse_error(own_from_world_, world_from_solid_.linear()));
    angle_error_ = length(e * abs(own.normal)) / length(half_space->normal);
    surface_error_ += angle_error_ * one_norm(half_space->point - offset_);
  }
}

Vec3d PlacedSolid::own_normal(Vec3d n) const {
  const Mat3& m = world_from_solid_.linear();
  return m.row[0] * n.x + m.row[1] * n.y + m.row[2] * n.z;
}

Vec3d PlacedSolid::world_normal(Vec3d n) const {
  return own_from_world_.row[0] * n.x + own_from_world_.row[1] * n.y + own_from_world_.row[2] * n.z;
}

Vec3d outward_normal(const PlacedSolid& placed, Patch patch, Vec3d p) {
  if (placed.space() == PlacedSolid::Space::world) return outward_normal(placed.shape(), patch, p);
  return normalize(placed.world_normal(outward_normal(placed.shape(), patch, placed.own_point(p))));
}

SurfaceUv surface_uv(const PlacedSolid& placed, Patch patch, Vec3d p) {
  const Mat3& m = placed.world_from_solid().linear();
  const SurfaceUv own = surface_uv(placed.solid(), patch, placed.own_point(p));
  return {own.uv, m * own.dpdu, m * own.dpdv};
}

bool contains(const PlacedSolid& placed, Vec3d p) {
  if (placed.space() == PlacedSolid::Space::world) return contains(placed.shape(), p);
  return contains(placed.shape(), placed.own_point(p));
}

Box3d bounds(const PlacedSolid& placed) {
  if (placed.space() == PlacedSolid::Space::world) {
    return padded(bounds(placed.shape()), placed.surface_error());
  }
  const Transform& map = placed.world_from_solid();
  const Box3d box =
      std::visit([&](const auto& kind) { return affine_bounds(kind, map); }, placed.shape());
  // Every term that the corners are sums of is at most this, and each has a few roundings.
  const Box3d own = bounds(placed.shape());
  // Where the solid is without bounds, so is the image, or it does not come in.
  const auto finite = [](double x) { return std::isfinite(x) ? std::abs(x) : 0.0; };
  Vec3d reach;
  for (std::size_t i = 0; i < 3; ++i) reach[i] = std::max(finite(own.min[i]), finite(own.max[i]));
  const double size = one_norm(magnitudes(map.linear()) * reach) + one_norm(map.offset());
  return padded(box, 16 * u_ * size);
}

double area(const PlacedSolid& placed) {
  const Mat3& linear = placed.world_from_solid().linear();
  return std::visit([&](const auto& kind) { return affine_area(kind, linear); }, placed.solid());
}

BoundaryPoint sample_boundary(const PlacedSolid& placed, Vec2d u, double u_patch) {
  const BoundaryPoint own = sample_boundary(placed.solid(), u, u_patch);
  const Transform& map = placed.world_from_solid();
  const double stretch = length(cofactors(map.linear()) * own.normal);
  return {map.point(own.p), normalize(placed.world_normal(own.normal)), own.patch,
          own.pdf_area / stretch};
}

double boundary_pdf_area(const PlacedSolid& placed, Patch patch, Vec3d p) {
  const Vec3d n = outward_normal(placed.solid(), patch, placed.own_point(p));
  const double stretch = length(cofactors(placed.world_from_solid().linear()) * n);
  return sampling_pdf_area(placed.solid(), patch, placed.own_point(p)) / stretch;
}

}  // namespace lapidary::geometry
