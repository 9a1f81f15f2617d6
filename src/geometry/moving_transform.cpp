#include "geometry/moving_transform.h"

#include <algorithm>
#include <cmath>

#include "geometry/rounded_bounds.h"

namespace lapidary::geometry {
namespace {

constexpr double u_ = rounding_unit;

/// First `b`, then `a`.
RoundedMap operator*(const RoundedMap& a, const RoundedMap& b) {
  const double size_a = frobenius_norm(a.map.linear()), size_b = frobenius_norm(b.map.linear());
  const double offset_a = one_norm(a.map.offset()), offset_b = one_norm(b.map.offset());
  // Of sums of three products, and of one more term.
  const double linear =
      a.error.linear * size_b + size_a * b.error.linear + 4 * u_ * size_a * size_b;
  const double offset = a.error.linear * offset_b + size_a * b.error.offset + a.error.offset +
                        5 * u_ * (size_a * offset_b + offset_a);
  return {a.map * b.map, {linear, offset}};
}

double largest(Vec3d scale) {
  return std::max(1.0, max_component(scale));
}

bool changes_shape_or_turns(const Motion& m) {
  return m.turn.angle != 0.0 || m.scale != Vec3d{1, 1, 1};
}

Vec3d scaled(const Motion& m, Vec3d v, double time) {
  const Vec3d f = Vec3d{1, 1, 1} + (m.scale - Vec3d{1, 1, 1}) * time;
  return {f.x * v.x, f.y * v.y, f.z * v.z};
}

/// What `box` becomes in a fixed map, with its rounding.
Box3d mapped(const Transform& map, const Box3d& box) {
  if (!box.bounded()) return box.empty() ? box : Box3d::all();
  const Vec3d reach = max(abs(box.min), abs(box.max));
  const double size = one_norm(magnitudes(map.linear()) * reach) + one_norm(map.offset());
  return padded(map.box(box), 16 * u_ * size);
}

}  // namespace

// The turn's angle has a relative error u; its axis 3 u, after it was made of unit length again;
// sine and cosine 2 u. So an entry, made of n_i n_j (1 - cos) and n_k sin, is off by less than
// 25 u, and the matrix by 75 u and what the angle does to it, sqrt(2) u |angle|. A factor 1 + t
// (scale - 1) is off by 3 u of the larger of 1 and scale, and its column by a rounding more.
RoundedMap map_at(const Motion& m, double time) {
  const Vec3d travel = m.travel * time;
  if (!changes_shape_or_turns(m)) {
    return {Transform::translation(travel), {0.0, u_ * one_norm(travel)}};
  }
  const Transform turn = Transform::rotation(m.turn.axis, m.turn.angle * time);
  const Transform about_center = turn * Transform::scaling(scaled(m, {1, 1, 1}, time));
  const double linear = (83 + 1.5 * std::abs(m.turn.angle)) * u_ * largest(m.scale);
  const double center = one_norm(m.center);
  const double offset =
      linear * center + 6 * u_ * (center * (1 + 2 * largest(m.scale)) + one_norm(travel));
  return {
      Transform::translation(m.center + travel) * about_center * Transform::translation(-m.center),
      {linear, offset}};
}

// A corner's path is p(t) = center + t travel + R(t) w(t) with w linear in t. Between two times
// that are h apart it is off the straight line by at most h^2 / 8 of the greatest second
// derivative, which is R'' w + 2 R' w': angle^2 |w| + 2 angle |w'|.
Box3d swept(const Motion& m, const Box3d& box) {
  if (!box.bounded()) return box.empty() ? box : Box3d::all();
  constexpr double step = 0.05;  // radians
  const double angle = std::abs(m.turn.angle);
  const double steps = std::clamp(std::ceil(angle / step), 1.0, 4096.0);
  Box3d all;
  double reach = 0, growth = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3d arm = box.corner(corner) - m.center;
    reach = std::max(reach, std::max(length(arm), length(scaled(m, arm, 1))));
    growth = std::max(growth, length(scaled(m, arm, 1) - arm));
  }
  for (double i = 0; i <= steps; ++i) {
    const double time = i / steps;
    const Transform turn = Transform::rotation(m.turn.axis, m.turn.angle * time);
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vec3d arm = scaled(m, box.corner(corner) - m.center, time);
      all.extend(m.center + m.travel * time + turn.vector(arm));
    }
  }
  const double bend = angle * angle * reach + 2 * angle * growth;
  const double rounding =
      (128 + 4 * angle) * u_ * (reach + one_norm(m.center) + one_norm(m.travel));
  return padded(all, bend / (8 * steps * steps) + rounding);
}

void MovingTransform::append(const Motion& motion) {
  steps_.push_back({last_, motion});
  last_ = {};
}

RoundedMap MovingTransform::rounded_at(double time) const {
  RoundedMap whole;
  for (const Step& step : steps_) {
    if (!step.before.is_identity()) whole = whole * RoundedMap{step.before, {}};
    whole = whole * map_at(step.motion, time);
  }
  return last_.is_identity() ? whole : whole * RoundedMap{last_, {}};
}

OwnSpace MovingTransform::space_at(double time) const {
  const RoundedMap whole = rounded_at(time);
  return OwnSpace(whole.map, whole.error);
}

Box3d MovingTransform::swept(const Box3d& own) const {
  Box3d box = mapped(last_, own);
  for (std::size_t i = steps_.size(); i-- > 0;) {
    box = mapped(steps_[i].before, geometry::swept(steps_[i].motion, box));
  }
  return box;
}

}  // namespace lapidary::geometry
