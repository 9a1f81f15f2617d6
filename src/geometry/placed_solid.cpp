#include "geometry/placed_solid.h"

#include <vector>

#include "geometry/affine_area.h"
#include "geometry/affine_error.h"
#include "geometry/curved_placement.h"
#include "geometry/rounded_bounds.h"
#include "math/frame.h"
#include "math/same_bits.h"

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
/// No point of the surface is further off than the corner of its box.
double image_error(const Superellipsoid& solid, const Superellipsoid& image, const Transform& map) {
  return point_error(map, solid.center) + u_ * length(image.radii);
}
template <typename Other>
double image_error(const Other&, const Other&, const Transform&) {
  return 0.0;  // its only image is itself
}

double displacement_of_image(const Solid& solid, const Solid& image, const Transform& map) {
  return std::visit(
      [&](const auto& kind) {
        using Kind = std::decay_t<decltype(kind)>;
        return image_error(kind, std::get<Kind>(image), map);
      },
      solid);
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

PlacedSolid::PlacedSolid(const Solid& solid, const Transform& world_from_solid) : shape_(solid) {
  if (world_from_solid.is_identity()) {
    space_ = Space::world;
    return;
  }
  const auto image = transformed(solid, world_from_solid);
  if (image && world_from_solid.linear() == Mat3::identity()) {
    space_ = Space::world;
    surface_error_ = displacement_of_image(solid, *image, world_from_solid);
    shape_ = *image;
    return;
  }
  const OwnSpace space(world_from_solid);
  if (image) set_baked(*image, solid, space);
  origin_ = std::make_shared<const Origin>(Origin{solid, space});
}

void PlacedSolid::set_baked(const Solid& image, const Solid& solid, const OwnSpace& space) {
  const Transform& map = space.world_from_own();
  space_ = Space::world;
  shape_ = image;
  surface_error_ = displacement_of_image(solid, image, map);
  if (const auto* half_space = std::get_if<HalfSpace>(&image)) {
    const auto& own = std::get<HalfSpace>(solid);
    const Mat3 e = transpose(inverse_error(space.own_from_world(), map.linear()));
    angle_error_ = length(e * abs(own.normal)) / length(half_space->normal);
    surface_error_ += angle_error_ * one_norm(half_space->point - map.offset());
  }
}

std::optional<PlacedSolid> PlacedSolid::fused(std::span<const PlacedSolid> half_spaces) {
  std::vector<HalfSpace> images, stated;
  for (const PlacedSolid& h : half_spaces) {
    images.push_back(std::get<HalfSpace>(h.shape()));
    stated.push_back(std::get<HalfSpace>(h.solid()));
  }
  const OwnSpace* space = half_spaces.front().own_space();
  const std::optional<Polyhedron> solid = intersection(stated);
  if (!solid || !std::isfinite(geometry::area(*solid))) return std::nullopt;
  PlacedSolid fused(space ? image(*solid, images, space->world_from_own()) : *solid, {});
  if (space) fused.origin_ = std::make_shared<const Origin>(Origin{*solid, *space});
  fused.surface_error_ = greatest(half_spaces, &PlacedSolid::surface_error_);
  fused.angle_error_ = greatest(half_spaces, &PlacedSolid::angle_error_);
  return fused;
}

double PlacedSolid::greatest(std::span<const PlacedSolid> solids, double PlacedSolid::*error) {
  double most = 0;
  for (const PlacedSolid& solid : solids) most = std::max(most, solid.*error);
  return most;
}

bool PlacedSolid::is_fused_of(std::span<const PlacedSolid> half_spaces) const {
  const auto has_planes = [&](const Solid& solid, auto plane_of) {
    const auto& polyhedron = std::get<Polyhedron>(solid);
    if (polyhedron.face_count() != half_spaces.size()) return false;
    for (std::size_t i = 0; i < half_spaces.size(); ++i) {
      const auto& plane = std::get<HalfSpace>(plane_of(half_spaces[i]));
      if (!same_bits(polyhedron.face(static_cast<Patch>(i)), plane)) return false;
    }
    return true;
  };
  const OwnSpace *space = own_space(), *other = half_spaces.front().own_space();
  if ((space == nullptr) != (other == nullptr)) return false;
  if (space && !same_bits(space->world_from_own(), other->world_from_own())) return false;
  return same_bits(surface_error_, greatest(half_spaces, &PlacedSolid::surface_error_)) &&
         same_bits(angle_error_, greatest(half_spaces, &PlacedSolid::angle_error_)) &&
         has_planes(shape_, [](const PlacedSolid& h) -> const Solid& { return h.shape(); }) &&
         has_planes(solid(), [](const PlacedSolid& h) -> const Solid& { return h.solid(); });
}

bool PlacedSolid::has_same_errors(const PlacedSolid& b) const {
  return same_bits(surface_error_, b.surface_error_) && same_bits(angle_error_, b.angle_error_);
}

const Transform& PlacedSolid::world_from_solid() const {
  static const Transform identity;
  return origin_ ? origin_->space.world_from_own() : identity;
}

void intervals_of_shape_line(const PlacedSolid& placed, const Line& line, EventBuffer& events) {
  intervals(placed.shape(), placed.shape_line(line), events);
}

Vec3d outward_normal(const PlacedSolid& placed, Patch patch, Vec3d p) {
  if (placed.space() == PlacedSolid::Space::world) return outward_normal(placed.shape(), patch, p);
  const OwnSpace& own = *placed.own_space();
  return normalize(own.world_normal(outward_normal(placed.shape(), patch, own.point(p))));
}

SurfaceUv surface_uv(const PlacedSolid& placed, Patch patch, Vec3d p) {
  const OwnSpace* space = placed.own_space();
  if (space == nullptr) return surface_uv(placed.shape(), patch, p);
  const Mat3& m = space->world_from_own().linear();
  const SurfaceUv own = surface_uv(placed.solid(), patch, space->point(p));
  return {own.uv, m * own.dpdu, m * own.dpdv};
}

std::optional<PatchPoint> point_at(const PlacedSolid& placed, const UvChart& chart, Vec2d uv) {
  const OwnSpace* space = placed.own_space();
  if (space == nullptr) return point_at(placed.shape(), chart, uv);
  auto at = point_at(placed.solid(), chart, uv);
  if (at) at->p = space->world_from_own().point(at->p);
  return at;
}

bool is_of(const PlacedSolid& placed, const UvChart& chart, Patch patch, Vec3d p) {
  const OwnSpace* space = placed.own_space();
  return is_of(placed.solid(), chart, patch, space == nullptr ? p : space->point(p));
}

bool contains(const PlacedSolid& placed, Vec3d p) {
  if (placed.space() == PlacedSolid::Space::world) return contains(placed.shape(), p);
  return contains(placed.shape(), placed.own_space()->point(p));
}

Box3d bounds(const PlacedSolid& placed) {
  if (placed.space() == PlacedSolid::Space::world) {
    const auto* polyhedron = std::get_if<Polyhedron>(&placed.shape());
    if (!polyhedron) return padded(bounds(placed.shape()), placed.surface_error());
    if (!placed.own_space()) return displaced_bounds(*polyhedron, placed.surface_error());
  }
  const Transform& map = placed.world_from_solid();
  const Box3d box =
      std::visit([&](const auto& kind) { return affine_bounds(kind, map); }, placed.solid());
  const bool is_number = !std::isnan(one_norm(box.min)) && !std::isnan(one_norm(box.max));
  if (!is_number) return Box3d::all();  // infinities that met
  // Every term that the corners are sums of is at most this, and each has a few roundings.
  const Box3d own = bounds(placed.solid());
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
  const OwnSpace* space = placed.own_space();
  if (space == nullptr) return own;
  const Transform& map = space->world_from_own();
  const double stretch = length(cofactors(map.linear()) * own.normal);
  return {map.point(own.p), normalize(space->world_normal(own.normal)), own.patch,
          own.pdf_area / stretch};
}

double boundary_pdf_area(const PlacedSolid& placed, Patch patch, Vec3d p) {
  const OwnSpace* space = placed.own_space();
  if (space == nullptr) return sampling_pdf_area(placed.shape(), patch, p);
  const Vec3d own = space->point(p), n = outward_normal(placed.solid(), patch, own);
  const double stretch = length(cofactors(space->world_from_own().linear()) * n);
  return sampling_pdf_area(placed.solid(), patch, own) / stretch;
}

}  // namespace lapidary::geometry
