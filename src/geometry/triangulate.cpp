#include "geometry/triangulate.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "math/constants.h"

namespace lapidary::geometry {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint32_t nowhere = 0xffffffff;  // in the queue

// Bound of the relative rounding error of the 2x2 determinant below (Shewchuk, "Adaptive Precision
// Floating-Point Arithmetic", 1997, ccwerrboundA).
constexpr double turn_error = 3.3306690738754716e-16;

// 1, -1 or 0: whether a, b, c turn left, right, or neither for certain.
int turn_of(Vec2d a, Vec2d b, Vec2d c) {
  const double left = (a.x - c.x) * (b.y - c.y);
  const double right = (a.y - c.y) * (b.x - c.x);
  const double det = left - right;
  const double bound = turn_error * (std::abs(left) + std::abs(right));
  return det > bound ? 1 : det < -bound ? -1 : 0;
}

// Twice the area vector, and whether it is more than rounding error.
struct AreaVector {
  Vec3d normal;
  bool certain = false;
};

AreaVector area_vector(std::span<const Vec3d> corners) {
  Vec3d sum, magnitude;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3d a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
    sum += cross(a, b);
    magnitude +=
        Vec3d(std::abs(a.y * b.z) + std::abs(a.z * b.y), std::abs(a.z * b.x) + std::abs(a.x * b.z),
              std::abs(a.x * b.y) + std::abs(a.y * b.x));
  }
  const double epsilon = std::numeric_limits<double>::epsilon();
  const double bound = epsilon * static_cast<double>(corners.size()) * max_component(magnitude);
  return {sum, max_component(abs(sum)) > bound};
}

// Drops the normal's largest axis such that the outline runs counter-clockwise.
Vec2d flatten(Vec3d p, Vec3d normal) {
  const Vec3d n = abs(normal);
  const auto turned = [](double forward, double x, double y) {
    return forward > 0 ? Vec2d{x, y} : Vec2d{y, x};
  };
  if (n.z >= n.x && n.z >= n.y) return turned(normal.z, p.x, p.y);
  if (n.x >= n.y) return turned(normal.x, p.y, p.z);
  return turned(normal.y, p.z, p.x);
}

void append_fan(std::size_t count, std::vector<Triangle>& triangles) {
  for (std::uint32_t i = 1; i + 1 < count; ++i) triangles.push_back({0, i, i + 1});
}

// No plane fits: the outline is a line or a point, or its parts cancel.
Triangulation fan_without_plane(std::span<const Vec3d> corners, std::vector<Triangle>& triangles) {
  append_fan(corners.size(), triangles);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const std::array<Vec3d, 3> part{corners[0], corners[i], corners[i + 1]};
    if (area_vector(part).certain) return Triangulation::forced;
  }
  return Triangulation::exact;
}

// The common case by itself: the better of two diagonals.
Triangulation cut_quad(std::span<const Vec3d> corners, std::vector<Triangle>& triangles) {
  const Vec3d normal = cross(corners[2] - corners[0], corners[3] - corners[1]);
  std::array<Vec2d, 4> p;
  for (std::size_t i = 0; i < 4; ++i) p[i] = flatten(corners[i], normal);
  const auto worst = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
    return std::min(turn_of(p[a], p[b], p[c]), turn_of(p[a], p[c], p[d]));
  };
  const int even = worst(0, 1, 2, 3);
  const int odd = worst(1, 2, 3, 0);
  const bool even_is_shorter =
      length_squared(corners[2] - corners[0]) <= length_squared(corners[3] - corners[1]);
  if (even > odd || (even == odd && even_is_shorter)) {
    triangles.insert(triangles.end(), {{0, 1, 2}, {0, 2, 3}});
  } else {
    triangles.insert(triangles.end(), {{1, 2, 3}, {1, 3, 0}});
  }
  return std::max(even, odd) < 0 ? Triangulation::forced : Triangulation::exact;
}

}  // namespace

Triangulation PolygonTriangulator::triangulate(std::span<const Vec3d> corners,
                                               std::vector<Triangle>& triangles) {
  assert(corners.size() >= 3);
  if (corners.size() == 3) {
    triangles.push_back({0, 1, 2});
    return Triangulation::exact;
  }
  if (corners.size() == 4) return cut_quad(corners, triangles);
  if (!project(corners)) return fan_without_plane(corners, triangles);
  link();
  for (Corner i = 0; i < corners.size(); ++i) cut_spikes(i, triangles);

  Tier tier = Tier::clear;
  Tier worst = tier;
  while (remaining_ > 3) {
    queue_all();
    if (cut_ears(tier, triangles)) {
      worst = std::max(worst, tier);
      tier = Tier::clear;
    } else {
      tier = static_cast<Tier>(static_cast<int>(tier) + 1);
    }
    if (work_ > work_limit) tier = Tier::any;
  }
  const Triangle last = ear_at(some_corner_);
  triangles.push_back(last);
  return worst >= Tier::convex || turn(last) < 0 ? Triangulation::forced : Triangulation::exact;
}

bool PolygonTriangulator::project(std::span<const Vec3d> corners) {
  const AreaVector area = area_vector(corners);
  if (!area.certain) return false;
  points_.clear();
  for (const Vec3d& p : corners) points_.push_back(flatten(p, area.normal));
  return true;
}

void PolygonTriangulator::link() {
  const auto n = static_cast<Corner>(points_.size());
  next_.resize(n);
  previous_.resize(n);
  for (Corner i = 0; i < n; ++i) {
    next_[i] = i + 1 < n ? i + 1 : 0;
    previous_[i] = i > 0 ? i - 1 : n - 1;
  }
  remaining_ = n;
  some_corner_ = 0;
  work_ = 0;
  reflex_.assign(n, 0);
  reflex_count_ = 0;
  for (Corner i = 0; i < n; ++i) update_reflex(i);
  place_in_queue_.resize(n);
  build_grid();
}

int PolygonTriangulator::turn(Corner a, Corner b, Corner c) const {
  return turn_of(points_[a], points_[b], points_[c]);
}

void PolygonTriangulator::queue_all() {
  queue_.clear();
  queue_front_ = 0;
  Corner i = some_corner_;
  for (std::size_t k = 0; k < remaining_; ++k, i = next_[i]) requeue(i);
}

void PolygonTriangulator::requeue(Corner i) {
  place_in_queue_[i] = static_cast<std::uint32_t>(queue_.size());
  queue_.push_back(i);
}

// One sweep over the queue. Below the best tier it ends with the first cut, for that may have made
// better ears. Returns whether anything was cut.
bool PolygonTriangulator::cut_ears(Tier tier, std::vector<Triangle>& triangles) {
  bool any = false;
  while (queue_front_ < queue_.size() && remaining_ > 3) {
    if (work_ > work_limit && tier != Tier::any) return any;
    const std::size_t place = queue_front_++;
    const Corner i = queue_[place];
    if (place_in_queue_[i] != place || !is_ear(i, tier)) continue;
    const Triangle ear = ear_at(i);
    triangles.push_back(ear);
    cut(i);
    cut_spikes(ear[0], triangles);
    cut_spikes(ear[2], triangles);
    any = true;
    if (tier != Tier::clear && work_ <= work_limit) return any;
  }
  return any;
}

bool PolygonTriangulator::is_ear(Corner i, Tier tier) {
  ++work_;
  if (tier == Tier::any) return true;
  const Triangle ear = ear_at(i);
  const int side = turn(ear);
  if (tier == Tier::flat) return side == 0;
  return side > 0 && (tier == Tier::convex || is_free(ear, tier));
}

// Whether the outline runs back over itself at `i`, or stays where it is.
bool PolygonTriangulator::is_spike(Corner i) const {
  const Vec2d back = points_[previous_[i]] - points_[i], on = points_[next_[i]] - points_[i];
  return back.x * on.x + back.y * on.y >= 0 && turn(ear_at(i)) == 0;
}

// Spikes enclose nothing and hide from their neighbours where the inside is, so they go at once.
void PolygonTriangulator::cut_spikes(Corner i, std::vector<Triangle>& triangles) {
  while (remaining_ > 3 && next_[previous_[i]] == i && is_spike(i)) {
    const Corner before = previous_[i], after = next_[i];
    triangles.push_back(ear_at(i));
    cut(i);
    i = is_spike(before) ? before : after;
  }
}

// A triangle that holds any other corner holds a reflex one, so only those are asked.
bool PolygonTriangulator::is_free(const Triangle& ear, Tier tier) {
  const Vec2d a = points_[ear[0]], b = points_[ear[1]], c = points_[ear[2]];
  const std::size_t first_row = cell(1, std::min({a.y, b.y, c.y}));
  const std::size_t last_row = cell(1, std::max({a.y, b.y, c.y}));
  for (std::size_t y = first_row; y <= last_row; ++y) {
    const Interval span = first_row == last_row
                              ? Interval{std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x})}
                              : span_in_row({a, b, c}, y);
    const std::size_t row = y * grid_size_[0];
    const std::uint32_t begin = cell_begin_[row + cell(0, span.min)];
    const std::uint32_t end = cell_begin_[row + cell(0, span.max) + 1];
    work_ += end - begin + 1;
    for (std::uint32_t k = begin; k < end; ++k) {
      if (blocks(cell_corners_[k], ear, tier)) return false;
    }
  }
  return true;
}

// The extent in x of a triangle's part in a row of the grid, a little more for rounding.
Interval PolygonTriangulator::span_in_row(const std::array<Vec2d, 3>& triangle,
                                          std::size_t y) const {
  const double height = 1 / cells_per_unit_.y;  // not 0: there are several rows
  const double low = grid_min_.y + (static_cast<double>(y) - 0.01) * height;
  const double high = low + 1.02 * height;
  Interval span;
  const auto extend = [&](double x) { span = {std::min(span.min, x), std::max(span.max, x)}; };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2d p = triangle[i], q = triangle[(i + 1) % 3];
    if (low <= p.y && p.y <= high) extend(p.x);
    for (const double edge : {low, high}) {
      if ((p.y < edge) != (q.y < edge)) extend(p.x + (q.x - p.x) * ((edge - p.y) / (q.y - p.y)));
    }
  }
  const double margin = 0.01 / cells_per_unit_.x;
  return {span.min - margin, span.max + margin};
}

bool PolygonTriangulator::blocks(Corner p, const Triangle& ear, Tier tier) const {
  const Corner a = ear[0], b = ear[1], c = ear[2];
  if (!reflex_[p] || p == a || p == b || p == c) return false;
  if (points_[p] == points_[a] || points_[p] == points_[c]) return false;
  if (points_[p] == points_[b]) {
    // The outline touches itself at the ear's tip; an edge from there may leave through the base.
    const auto enters = [&](Corner q) { return turn(a, b, q) > 0 && turn(b, c, q) > 0; };
    return enters(next_[p]) || enters(previous_[p]);
  }
  const int least = std::min({turn(a, b, p), turn(b, c, p), turn(c, a, p)});
  return tier == Tier::clear ? least >= 0 : least > 0;
}

void PolygonTriangulator::cut(Corner i) {
  const Corner before = previous_[i], after = next_[i];
  next_[before] = after;
  previous_[after] = before;
  reflex_count_ -= reflex_[i];
  reflex_[i] = 0;
  place_in_queue_[i] = nowhere;
  some_corner_ = after;
  --remaining_;
  for (const Corner neighbour : {before, after}) {
    update_reflex(neighbour);
    requeue(neighbour);
  }
  if (reflex_count_ * 2 < grid_count_) build_grid();
}

void PolygonTriangulator::update_reflex(Corner i) {
  const std::uint8_t now = turn(ear_at(i)) <= 0 ? 1 : 0;
  reflex_count_ = reflex_count_ + now - reflex_[i];
  reflex_[i] = now;
}

std::size_t PolygonTriangulator::cell(std::size_t axis, double x) const {
  const double at = (x - grid_min_[axis]) * cells_per_unit_[axis];
  const auto last = grid_size_[axis] - 1;
  return at > 0 ? std::min(static_cast<std::size_t>(std::min(at, 1e9)), last) : 0;
}

// Sorts the reflex corners into about as many cells as there are corners.
void PolygonTriangulator::build_grid() {
  Vec2d low{infinity, infinity}, high{-infinity, -infinity};
  Corner i = some_corner_;
  for (std::size_t k = 0; k < remaining_; ++k, i = next_[i]) {
    low = {std::min(low.x, points_[i].x), std::min(low.y, points_[i].y)};
    high = {std::max(high.x, points_[i].x), std::max(high.y, points_[i].y)};
  }
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(reflex_count_))) + 1;
  grid_size_ = {side, side};
  grid_min_ = low;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double extent = high[axis] - low[axis];
    cells_per_unit_[axis] = extent > 0 ? static_cast<double>(side) / extent : 0;
  }
  cell_begin_.assign(side * side + 1, 0);
  const auto cell_of = [&](Corner c) {
    return cell(1, points_[c].y) * side + cell(0, points_[c].x);
  };
  const auto for_each_reflex = [&](auto visit) {
    Corner c = some_corner_;
    for (std::size_t k = 0; k < remaining_; ++k, c = next_[c]) {
      if (reflex_[c]) visit(c);
    }
  };
  for_each_reflex([&](Corner c) { ++cell_begin_[cell_of(c)]; });
  std::uint32_t total = 0;
  for (std::uint32_t& begin : cell_begin_) begin = total += begin;
  cell_corners_.resize(total);
  for_each_reflex([&](Corner c) { cell_corners_[--cell_begin_[cell_of(c)]] = c; });
  grid_count_ = total;
}

}  // namespace lapidary::geometry
