#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "exact_solids.h"
#include "geometry/solid.h"

/// Compares the events that the code finds on a line with those of exact_solids.h.
namespace lapidary::geometry::exact {

inline double as_double(Quad x) {
  return static_cast<double>(x);
}

/// What came out of comparing many lines of one kind.
struct Tally {
  int hits = 0, misses = 0, disagreements = 0;
  double worst = 0;                   ///< greatest |error| / tau
  std::vector<double> relative_taus;  ///< tau over the distances involved, of steep hits
};

struct Case {
  Solid solid;
  Line line;
  ExactLine exact_line;  ///< in the solid's coordinates
  double scale;          ///< of distances in the solid's coordinates
  double rounding;       ///< relative to them, what is accepted in degenerate cases
};

inline std::string describe(const Case& c) {
  std::ostringstream text;
  text.precision(17);
  text << "kind " << c.solid.index() << " origin " << c.line.origin.x << ' ' << c.line.origin.y
       << ' ' << c.line.origin.z << " direction " << c.line.direction.x << ' ' << c.line.direction.y
       << ' ' << c.line.direction.z;
  return text.str();
}

/// Where code and oracle disagree on whether there is a hit at all, the stretch in question must
/// be within rounding of the surface.
inline ::testing::AssertionResult check_negligible(const Case& c, Quad enter, Quad leave) {
  const Quad middle = (enter + leave) / 2;
  const Vec p = c.exact_line.at(middle);
  const double distance = as_double(magnitude(depth(c.solid, p)));
  const double size = c.scale + as_double(length(p - c.exact_line.origin));
  if (distance <= c.rounding * size) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure()
         << "code and oracle disagree on a chord at depth " << distance << ", size " << size;
}

/// A line that runs along a face to within rounding has no bound: there the stretch in question
/// must be within rounding of the surface, too.
inline ::testing::AssertionResult check_event(const Case& c, const Event& event, Quad expected,
                                              Tally& tally) {
  const double error = as_double(magnitude(Quad(event.t) - expected));
  if (!std::isfinite(event.tau) || error > event.tau) {
    const double angle = c.rounding * (1.0 + c.scale / least_extent(c.solid));
    if (runs_along_face(c.solid, c.exact_line, angle) && check_negligible(c, event.t, expected)) {
      ++tally.disagreements;
      return ::testing::AssertionSuccess();
    }
    return ::testing::AssertionFailure()
           << "t " << event.t << " is off by " << error << ", bound " << event.tau;
  }
  if (event.tau > 0) tally.worst = std::max(tally.worst, error / event.tau);
  return ::testing::AssertionSuccess();
}

inline ::testing::AssertionResult check_bounded(const Case& c, const EventBuffer& events,
                                                Tally& tally) {
  const Stretch expected = inside(c.solid, c.exact_line);
  if (events.inside_at_start()) return ::testing::AssertionFailure() << "inside at infinity";
  if (events.empty()) {
    ++tally.misses;
    if (expected.empty()) return ::testing::AssertionSuccess();
    ++tally.disagreements;
    return check_negligible(c, expected.enter, expected.leave);
  }
  if (events.size() != 2 || events[0].crossing != Crossing::enter ||
      events[1].crossing != Crossing::leave || !(events[0].t < events[1].t)) {
    return ::testing::AssertionFailure() << "events do not alternate";
  }
  if (expected.empty()) {
    ++tally.disagreements;
    return check_negligible(c, events[0].t, events[1].t);
  }
  ++tally.hits;
  const auto first = check_event(c, events[0], expected.enter, tally);
  return first ? check_event(c, events[1], expected.leave, tally) : first;
}

inline ::testing::AssertionResult check_half_space(const Case& c, const EventBuffer& events,
                                                   Tally& tally) {
  const auto& h = std::get<HalfSpace>(c.solid);
  const Stretch expected = inside(h, c.exact_line);
  if (events.empty()) {
    ++tally.misses;
    const Vec n(h.normal);
    const Quad slope = dot(n, c.exact_line.direction);
    const double size = as_double(length(n) * length(c.exact_line.direction));
    if (std::abs(as_double(slope)) > c.rounding * size) {
      return ::testing::AssertionFailure() << "not parallel, but no event";
    }
    const double inside_by = as_double(depth(h, c.exact_line.origin));
    if (std::abs(inside_by) > c.rounding * c.scale && (inside_by > 0) != events.inside_at_start()) {
      return ::testing::AssertionFailure() << "parallel on the wrong side";
    }
    return ::testing::AssertionSuccess();
  }
  const bool leaves = events[0].crossing == Crossing::leave;
  if (events.size() != 1 || events.inside_at_start() != leaves ||
      leaves != (expected.leave < Quad(never))) {
    return ::testing::AssertionFailure() << "wrong side at the start";
  }
  ++tally.hits;
  return check_event(c, events[0], leaves ? expected.leave : expected.enter, tally);
}

inline ::testing::AssertionResult check(const Case& c, const EventBuffer& events, Tally& tally) {
  const auto result =
      c.solid.index() == 2 ? check_half_space(c, events, tally) : check_bounded(c, events, tally);
  if (!result) return ::testing::AssertionFailure() << result.message() << ", " << describe(c);
  const double d = length(c.line.direction);
  for (const Event& e : events) {
    const double reach = length(c.line.origin) + d * std::abs(e.t);
    tally.relative_taus.push_back(e.tau * d / reach);
  }
  return result;
}

inline double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

inline double distance_scale(const Solid& solid, const Line& line) {
  const Vec3d reference = std::visit(
      [](const auto& kind) {
        if constexpr (requires { kind.center; })
          return kind.center;
        else if constexpr (requires { kind.min; })
          return kind.min;
        else if constexpr (requires { kind.point; })
          return kind.point;
        else if constexpr (requires { kind.from; })
          return kind.from;
        else
          return bounds(kind).bounded() ? bounds(kind).center() : Vec3d{};
      },
      solid);
  const Box3d box = bounds(solid);
  return length(line.origin - reference) + (box.bounded() ? length(box.extent()) : 0.0);
}

/// The bounds hold on every line, and they are not idle: the worst error comes within a factor of
/// ten of its bound, so bounds a hundred times smaller would fail.
inline void expect_tight(const Tally& tally, double median_tau) {
  EXPECT_GT(tally.worst, 0.1);
  EXPECT_LT(median(tally.relative_taus), median_tau);
  ::testing::Test::RecordProperty("worst_error_over_tau", std::to_string(tally.worst));
  ::testing::Test::RecordProperty("hits", tally.hits);
  ::testing::Test::RecordProperty("misses", tally.misses);
  ::testing::Test::RecordProperty("disagreements", tally.disagreements);
}

}  // namespace lapidary::geometry::exact
