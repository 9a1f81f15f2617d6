#pragma once

#include <algorithm>
#include <functional>
#include <sstream>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/interval_events.h"

/// Compares the events of any body with a slow oracle of points.
namespace lapidary::geometry::exact {

/// What is known about a body on one line, in more than double precision.
struct Oracle {
  std::vector<long double> touches;               ///< every t at which the boundary may be met
  std::function<bool(long double)> inside;        ///< at t, if not within rounding of the boundary
  std::function<long double(long double)> depth;  ///< distance from the boundary at t
  long double rounding = 0;  ///< distance within which a point counts as on the boundary
  bool bounded = true;
};

/// What came out of comparing many lines.
struct BodyTally {
  int hits = 0, misses = 0, excused = 0;
  double worst = 0;                   ///< greatest |error| / tau of events with bounds that matter
  std::vector<double> relative_taus;  ///< tau over the distances involved
};

inline ::testing::AssertionResult check_order(const EventBuffer& events, bool bounded) {
  bool inside = events.inside_at_start();
  if (bounded && inside) return ::testing::AssertionFailure() << "inside at infinity";
  for (std::size_t i = 0; i < events.size(); ++i) {
    const Event& e = events[i];
    if ((e.crossing == Crossing::enter) == inside) {
      return ::testing::AssertionFailure() << "event " << i << " does not alternate";
    }
    if (i > 0 && !(events[i - 1].t < e.t)) {
      return ::testing::AssertionFailure() << "event " << i << " is not after the one before";
    }
    if (!(e.tau >= 0.0)) return ::testing::AssertionFailure() << "tau is " << e.tau;
    inside = !inside;
  }
  if (bounded && inside) return ::testing::AssertionFailure() << "odd number of events";
  return ::testing::AssertionSuccess();
}

inline bool state_at(const EventBuffer& events, long double t) {
  bool inside = events.inside_at_start();
  for (const Event& e : events) {
    if (t < e.t) break;
    inside = e.crossing == Crossing::enter;
  }
  return inside;
}

/// Outside of the stretches that the bounds cover, the events must say the same as the oracle,
/// except at points within rounding of the boundary. That also makes a bound that is too small an
/// error: the state would be wrong between the event and the exact one.
inline ::testing::AssertionResult check_body(const EventBuffer& events, const Oracle& oracle,
                                             BodyTally& tally) {
  const auto ordered = check_order(events, oracle.bounded);
  if (!ordered) return ordered;
  ++(events.empty() ? tally.misses : tally.hits);
  std::vector<long double> cuts = oracle.touches;
  for (const Event& e : events) {
    cuts.push_back(static_cast<long double>(e.t) - e.tau);
    cuts.push_back(static_cast<long double>(e.t) + e.tau);
  }
  std::ranges::sort(cuts);
  const auto is_covered = [&](long double t) {
    return std::ranges::any_of(events, [&](const Event& e) {
      const long double t_event = e.t;
      return t_event - e.tau <= t && t <= t_event + e.tau;
    });
  };
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const long double t = (cuts[i] + cuts[i + 1]) / 2;
    if (is_covered(t) || state_at(events, t) == oracle.inside(t)) continue;
    if (oracle.depth(t) <= oracle.rounding) {
      ++tally.excused;
      continue;
    }
    return ::testing::AssertionFailure()
           << "at t = " << static_cast<double>(t) << " the events say "
           << (state_at(events, t) ? "inside" : "outside") << ", at distance "
           << static_cast<double>(oracle.depth(t)) << " from the boundary, more than "
           << static_cast<double>(oracle.rounding);
  }
  return ::testing::AssertionSuccess();
}

/// How far events are from the nearest touch, in units of their bounds: whether bounds are idle.
inline void tally_bounds(const EventBuffer& events, const Oracle& oracle, double unit,
                         BodyTally& tally) {
  for (const Event& e : events) {
    tally.relative_taus.push_back(e.tau * unit);
    long double nearest = infinity;
    for (const long double t : oracle.touches) nearest = std::min(nearest, std::abs(t - e.t));
    if (e.tau > 0.0) tally.worst = std::max(tally.worst, static_cast<double>(nearest) / e.tau);
  }
}

inline double quantile(std::vector<double> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Half of the bounds are within a few roundings, and the worst error within a factor of a hundred
/// of its bound, so bounds a hundred times smaller would fail.
inline void expect_useful(const BodyTally& tally, double median_tau) {
  ASSERT_FALSE(tally.relative_taus.empty());
  EXPECT_LT(quantile(tally.relative_taus, 0.5), median_tau);
  EXPECT_GT(tally.worst, 0.01);
  EXPECT_LE(tally.worst, 1.0);
  ::testing::Test::RecordProperty("median_tau",
                                  std::to_string(1e16 * quantile(tally.relative_taus, 0.5)));
  ::testing::Test::RecordProperty("worst_error_over_tau", std::to_string(tally.worst));
  ::testing::Test::RecordProperty("hits", tally.hits);
  ::testing::Test::RecordProperty("misses", tally.misses);
  ::testing::Test::RecordProperty("excused", tally.excused);
}

}  // namespace lapidary::geometry::exact
