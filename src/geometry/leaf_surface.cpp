#include "geometry/leaf_surface.h"

#include <algorithm>

namespace lapidary::geometry {
namespace {

/// Areas of the faces of a box across each axis.
Vec3d face_areas(const Box3d& box) {
  const Vec3d e = box.extent();
  return {e.y * e.z, e.z * e.x, e.x * e.y};
}

double sum(Vec3d v) {
  return v.x + v.y + v.z;
}

}  // namespace

LeafSurface::LeafSurface(const PlacedSolid& solid, const Box3d& box, SeenSides sides)
    : solid_(solid), box_(box), sides_(sides) {
  measure_ = area(solid);
  // A convex solid has no more surface than its box: what has is folded, or sticks out of it.
  if (!(measure_ <= 2.0 * sum(face_areas(box)))) choose_lines();
}

void LeafSurface::choose_lines() {
  const Vec3d areas = face_areas(box_);
  const auto* plane = std::get_if<HalfSpace>(&solid_.shape());
  if (plane == nullptr) {
    axis_share_ = areas / sum(areas);
    constexpr double mean_of_one_norm = 1.5;  // over all unit normals
    measure_ = sum(areas) / mean_of_one_norm;
    return;
  }
  const Vec3d n = outward_normal(solid_, 0, {});
  std::size_t best = 0;
  double most = -1.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double density = areas[i] > 0.0 ? std::abs(n[i]) / areas[i] : 0.0;
    if (density > most) most = density, best = i;
  }
  axis_share_[best] = 1.0;
  measure_ = 1.0 / most;
}

bool LeafSurface::is_seen(Vec3d p, Vec3d normal, const std::optional<Vec3d>& eye) const {
  if (!eye) return true;
  const double height = dot(*eye - p, normal);
  return height > 0.0 ? sides_.outside : height < 0.0 && sides_.inside;
}

std::optional<LeafPoint> LeafSurface::draw(Vec2d u, double part,
                                           const std::optional<Vec3d>& eye) const {
  if (axis_share_ != Vec3d{}) return draw_on_line(u, part, eye);
  const BoundaryPoint b = sample_boundary(solid_, u, part);
  if (!(b.pdf_area > 0.0) || !is_seen(b.p, b.normal, eye)) return std::nullopt;
  return LeafPoint{b.p, b.normal, b.patch, b.pdf_area, 1.0};
}

std::optional<LeafPoint> LeafSurface::draw_on_line(Vec2d u, double part,
                                                   const std::optional<Vec3d>& eye) const {
  std::size_t axis = 0;
  for (; axis < 2 && part >= axis_share_[axis]; ++axis) part -= axis_share_[axis];
  if (!(axis_share_[axis] > 0.0)) return std::nullopt;  // by rounding of the shares
  const Vec3d extent = box_.extent();
  const std::size_t j = (axis + 1) % 3, k = (axis + 2) % 3;
  Line line{box_.min, {0, 0, 0}};
  line.direction[axis] = 1.0;
  line.origin[j] += u.x * extent[j];
  line.origin[k] += u.y * extent[k];

  EventBuffer events;
  intervals(solid_, line, events);
  // Faces often lie in the box's own. A little too much is no harm: nothing is seen there.
  const double slack = 1e-9 * (extent[axis] + std::abs(box_.min[axis]));
  const auto seen = [&](const Event& e) {
    if (!(e.t >= -slack && e.t <= extent[axis] + slack)) return false;
    const Vec3d p = line.at(e.t);
    return is_seen(p, outward_normal(solid_, e.patch, p), eye);
  };
  const auto count = std::count_if(events.begin(), events.end(), seen);
  if (count == 0) return std::nullopt;
  const double place = part / axis_share_[axis] * static_cast<double>(count);
  auto skipped = std::min(static_cast<std::ptrdiff_t>(place), count - 1);
  const auto* chosen = std::find_if(events.begin(), events.end(),
                                    [&](const Event& e) { return seen(e) && skipped-- == 0; });
  const Vec3d p = line.at(chosen->t), n = outward_normal(solid_, chosen->patch, p);
  return LeafPoint{p, n, chosen->patch, line_density(n), static_cast<double>(count)};
}

double LeafSurface::line_density(Vec3d normal) const {
  const Vec3d areas = face_areas(box_);
  double density = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (axis_share_[i] > 0.0) density += axis_share_[i] * std::abs(normal[i]) / areas[i];
  }
  return density;
}

double LeafSurface::density(Patch patch, Vec3d p) const {
  if (axis_share_ == Vec3d{}) return boundary_pdf_area(solid_, patch, p);
  return line_density(outward_normal(solid_, patch, p));
}

}  // namespace lapidary::geometry
