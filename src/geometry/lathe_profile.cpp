#include "geometry/lathe_profile.h"

#include <algorithm>

#include "math/roots.h"

namespace lapidary::geometry {
namespace {

using Data = Lathe::Data;

constexpr double u_ = rounding_unit;

}  // namespace

LatheProfile::Distance LatheProfile::distance(std::uint32_t edge, double s) const {
  const Data::Edge& e = data_.edges[edge];
  const Data::Corner corner = data_.corners[edge];
  const ProfileLine::Point p = c_.at(s);
  const double out = e.outward * (p.rho - corner.r), up = e.upward * (p.z - corner.height);
  const double rounding = c_.rounding(p) + 8 * u_ * (std::abs(out) + std::abs(up));
  return {out + up, rounding, rounding + c_.line.error_at(s),
          e.outward * c_.rho_slope(p) + e.upward * c_.z1};
}

/// Whether the line passes this close to the corner: it does so at s with a distance in rho of
/// `difference`, which is longer than that across the line.
bool LatheProfile::is_on_line(const ProfileLine::Point& p, double difference) const {
  return std::abs(difference * c_.z1) <= c_.blur * std::hypot(c_.rho_slope(p), c_.z1);
}

/// Whether the line runs along an edge at this corner, which it passes within rounding.
bool LatheProfile::runs_along_edge(std::uint32_t corner) const {
  const auto is_on = [&](std::uint32_t other) {
    const double s = c_.passes(data_.corners[other].height);
    const ProfileLine::Point p = c_.at(s);
    return std::abs(s) < c_.end && is_on_line(p, p.rho - data_.corners[other].r);
  };
  return is_on(corner) && (is_on(data_.edges[corner].to) || is_on(data_.edges[corner].previous));
}

/// The shift moves the line by tie_shift, and with it the place where it passes the corner's
/// height.
bool LatheProfile::is_outer_after_shift(const ProfileLine::Point& p) const {
  const double across = p.rho > 0.0 ? (tie_shift.x * p.across.x + tie_shift.y * p.across.y) / p.rho
                                    : std::hypot(tie_shift.x, tie_shift.y);
  return across > c_.rho_slope(p) * c_.inverse_z1 * tie_shift.z;
}

Passing LatheProfile::pass(std::uint32_t corner) const {
  const auto [r, height] = data_.corners[corner];
  const double s = c_.passes(height);
  if (r == 0.0 || std::abs(s) >= c_.end) return {s, true, true};
  const ProfileLine::Point p = c_.at(s);
  const double difference = p.rho - r;
  if (std::abs(difference) > c_.fog) return {s, difference > 0.0, true};
  return {s, runs_along_edge(corner) ? is_outer_after_shift(p) : difference > 0.0, false};
}

/// Whether all corners in the box are certainly outer and no edge is met, or all inner.
bool LatheProfile::is_apart(const Data::Node& node) const {
  double low = c_.passes(node.height_min), high = c_.passes(node.height_max);
  if (low > high) std::swap(low, high);
  if (low == high && std::abs(low) == c_.end) return true;
  const auto square = [&](double s) {
    const double x = std::fma(s, c_.w.x, c_.v.x), y = std::fma(s, c_.w.y, c_.v.y);
    return x * x + y * y;
  };
  // Rounding may take the box to the other side of the fog by as much again.
  const double margin = 2 * c_.fog, inner = node.r_min - margin, outer = node.r_max + margin;
  const double at_low = square(low), at_high = square(high);
  if (inner > 0.0 && std::max(at_low, at_high) < inner * inner) {
    return std::abs(low) < c_.end && std::abs(high) < c_.end;
  }
  if (std::min(at_low, at_high) <= outer * outer) return false;
  const double vw = c_.v.x * c_.w.x + c_.v.y * c_.w.y, ww = c_.speed * c_.speed;
  const double nearest = ww > 0.0 ? std::clamp(-vw / ww, low, high) : low;
  return square(nearest) > outer * outer;
}

void LatheProfile::find(ProfileCrossings& found) const {
  for (std::uint32_t n = 0; n < data_.nodes.size();) {
    const Data::Node& node = data_.nodes[n];
    if (is_apart(node)) {
      n = node.skip;
      continue;
    }
    Passing from{}, to{};
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const bool goes_on = i > node.begin && data_.edges[i - 1].to == i;
      from = goes_on ? to : pass(i);
      to = pass(data_.edges[i].to);
      cross(i, from, to, found);
    }
    ++n;
  }
}

void LatheProfile::cross(std::uint32_t edge, const Passing& from, const Passing& to,
                         ProfileCrossings& found) const {
  const Passing& low = from.s <= to.s ? from : to;
  const Passing& high = from.s <= to.s ? to : from;
  if (from.is_outer && to.is_outer) {
    if (low.s < high.s) cross_twice(edge, low.s, high.s, found);
  } else if (from.is_outer != to.is_outer) {
    // Of two corners at the same place it does not matter which is the lower one.
    const double s = low.s < high.s ? root(edge, Bracket{low.s, high.s, !low.is_outer}) : low.s;
    found.push({s, edge, from.is_outer == c_.is_rising()});
  }
}

/// Between two outer corners. What is less than rounding beyond the edge is no chord.
void LatheProfile::cross_twice(std::uint32_t edge, double low, double high,
                               ProfileCrossings& found) const {
  const double middle = closest(edge);
  if (!(low < middle && middle < high)) return;
  const Distance at = distance(edge, middle);
  if (!(at.value < -at.error)) return;
  const bool rises = data_.along(edge).height > 0.0;
  found.push({root(edge, Bracket{low, middle, false}), edge, rises});
  found.push({root(edge, Bracket{middle, high, true}), edge, !rises});
}

/// Where the distance from the edge is least: where rho changes at the rate q at which the edge's
/// radius does, on the hyperbola rho^2 = nearest^2 + ww (s - m)^2. Not a number where there is no
/// such place.
double LatheProfile::closest(std::uint32_t edge) const {
  const Data::Edge& e = data_.edges[edge];
  const double ww = c_.speed * c_.speed;
  const double q = -e.upward * c_.z1 / e.outward;
  const double k = std::abs(difference_of_products(c_.v.x, c_.w.y, c_.v.y, c_.w.x));
  const double nearest = k / c_.speed, m = -(c_.v.x * c_.w.x + c_.v.y * c_.w.y) / ww;
  const double steeper = (c_.speed - q) * (c_.speed + q);
  return m + q * nearest / (c_.speed * std::sqrt(steeper));
}

/// About where the distance from the edge is 0: outward^2 rho^2 = (g + s k)^2, of whose roots those
/// on the other side of the axis are not meant.
double LatheProfile::guess(std::uint32_t edge, const Bracket& bracket) const {
  const Data::Edge& e = data_.edges[edge];
  const Data::Corner corner = data_.corners[edge];
  const double g = e.outward * corner.r + e.upward * (corner.height - c_.z0);
  const double k = -e.upward * c_.z1, square = e.outward * e.outward;
  const auto of = [](Vec2d a, Vec2d b) { return a.x * b.x + a.y * b.y; };
  const double a = square * of(c_.w, c_.w) - k * k, b = square * of(c_.v, c_.w) - g * k;
  const double c = square * of(c_.v, c_.v) - g * g;
  const auto roots = a != 0.0 ? half_quadratic_roots(a, b, c) : std::nullopt;
  // Out of the outer end Newton's method goes straight to the root, as the distance is convex.
  const double outer_end = bracket.is_negative_at_low ? bracket.high : bracket.low;
  if (!roots) return outer_end;
  // Of two roots the distance comes down at the first and goes up at the second. At the ends of
  // the bracket it may be within rounding of 0, so that which one is meant must be clear here.
  const double first = bracket.is_negative_at_low ? roots->high : roots->low;
  const double second = bracket.is_negative_at_low ? roots->low : roots->high;
  const bool is_first = std::fma(first, k, g) >= 0.0 || std::fma(second, k, g) < 0.0;
  return std::clamp(is_first ? first : second, bracket.low, bracket.high);
}

/// Where the distance is lost in its rounding.
double LatheProfile::root(std::uint32_t edge, const Bracket& bracket) const {
  const auto f = [&](double s) {
    const Distance d = distance(edge, s);
    return ValueAndSlope{std::abs(d.value) <= 0.25 * d.rounding ? 0.0 : d.value, d.slope};
  };
  return bracketed_root(f, bracket, guess(edge, bracket), 0.0);
}

/// How far it is from s, about a root, to the nearest place in this direction where the distance
/// from the edge exceeds its error, as its sign is certain there. Guessed from the slope, or the
/// curvature where the line grazes, and verified. All crossings are within 2 end.
double LatheProfile::reach(std::uint32_t edge, double s, double direction) const {
  const Distance at = distance(edge, s);
  const double bend = c_.speed * c_.speed / std::max(data_.radius, c_.at(s).rho);
  const double guess = 1.125 * at.error / (std::abs(at.slope) + std::sqrt(at.error * bend));
  // At an origin that is stated exactly nothing is rounded.
  const double least = u_ * std::max(2 * std::abs(s), u_ * c_.end);
  for (double x = std::max(guess, least); x < 2 * c_.end; x *= 1.5) {
    const Distance there = distance(edge, s + direction * x);
    if (std::abs(there.value) > there.error) return x;
  }
  return 2 * c_.end;
}

/// How far from the corner, which the line passes within rounding, the exact line may cross what is
/// beyond it: first `edge`, and while that is as short as rounding, the next. An edge that the line
/// runs along is on one side by tie_shift.
double LatheProfile::reach_past(std::uint32_t edge, std::uint32_t corner, double tau) const {
  double way = 0;
  const double start = pass(corner).s;
  for (std::size_t i = 0; i < data_.edges.size(); ++i) {
    const bool is_forward = edge == corner;
    const std::uint32_t next = is_forward ? data_.edges[edge].to : edge;
    const Passing far = pass(next);
    const double size = std::abs(far.s - start);
    if (far.is_certain) {
      const double direction = far.s < start ? -1.0 : 1.0;
      return std::max(way, std::min(reach(edge, start, direction), size));
    }
    if (size > tau + c_.slip) return way;
    way = std::max(way, size);
    edge = is_forward ? next : data_.edges[next].previous;
    corner = next;
  }
  return way;
}

/// Whether the corner may be on the other side of the exact line, and the crossing of this edge
/// then gone. It is not if the sign is certain half-way to it.
bool LatheProfile::hangs_on(const ProfileCrossing& crossing, const Passing& corner) const {
  if (corner.is_certain) return false;
  if (std::abs(crossing.s - corner.s) <= 2 * c_.slip) return true;
  const Distance half_way = distance(crossing.edge, 0.5 * (crossing.s + corner.s));
  return std::abs(half_way.value) <= half_way.error;
}

/// The exact line may cross the other edge at a corner instead.
double LatheProfile::tau(const ProfileCrossing& crossing) const {
  const std::uint32_t edge = crossing.edge, to = data_.edges[edge].to;
  const double own = std::max(reach(edge, crossing.s, -1.0), reach(edge, crossing.s, 1.0));
  double tau = own;
  const auto extend = [&](std::uint32_t corner, std::uint32_t other) {
    const Passing p = pass(corner);
    if (!hangs_on(crossing, p)) return;
    const double beyond = 2 * c_.slip + reach_past(other, corner, own);
    tau = std::max(tau, std::abs(crossing.s - p.s) + beyond);
  };
  extend(edge, data_.edges[edge].previous);
  extend(to, to);
  return tau;
}

}  // namespace lapidary::geometry
