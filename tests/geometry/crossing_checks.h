#pragma once

#include "event_checks.h"
#include "exact_curved.h"
#include "hostile_curved.h"
#include "superellipsoid_shapes.h"

/// Compares the events that the code finds on a line with the exact crossings, for solids that a
/// line may cross any number of times.
namespace lapidary::geometry::exact {

template <typename... Numbers>
std::string in_words(std::string_view name, Numbers... numbers) {
  std::ostringstream text;
  text.precision(17);
  text << name;
  ((text << ' ' << numbers), ...);
  return text.str();
}
inline std::string words_of(Vec3d v) {
  return in_words("", v.x, v.y, v.z);
}
inline std::string describe(const Cone& c) {
  return in_words("cone", words_of(c.from), words_of(c.to), c.radius, c.radius2);
}
inline std::string describe(const Torus& t) {
  return in_words("torus", words_of(t.center), words_of(t.axis), t.major_radius, t.minor_radius);
}
inline std::string describe(const Quadric& q) {
  return in_words("quadric", words_of(q.form->squares), words_of(q.form->products),
                  words_of(q.form->linear), q.form->constant);
}

inline std::string describe(const Superellipsoid& s) {
  return in_words("superellipsoid", words_of(s.center), words_of(s.radii), s.e, s.n);
}

template <typename Kind>
struct Trial {
  Kind kind;
  Line line;
  ExactLine exact_line;  ///< in the kind's own coordinates
  double scale;          ///< of distances there
  double rounding;       ///< relative to them, what is accepted in degenerate cases

  bool is_on_surface(Quad t) const {
    const Vec p = exact_line.at(t);
    const double size = scale + as_double(length(p - exact_line.origin));
    return as_double(magnitude(depth(kind, p))) <= rounding * depth_scale(kind, size);
  }
};

/// Walks over both lists. A chord that only one of them has must be negligible: a reported one no
/// longer than its bounds, a missing one within rounding of the surface. On a line that runs along
/// the boundary there is no bound, but the stretch in question must be within rounding of it.
template <typename Kind>
::testing::AssertionResult match(const Trial<Kind>& trial, const EventBuffer& events,
                                 const Crossings& expected, Tally& tally) {
  std::size_t i = 0, k = 0;
  while (i < expected.t.size() || k < events.size()) {
    const bool both = i < expected.t.size() && k < events.size();
    const bool is_along =
        runs_along(trial.kind, trial.exact_line,
                   trial.rounding * (1.0 + trial.scale / least_extent(trial.kind)));
    const bool exact_enters = (i % 2 == 0) != expected.inside_at_start;
    if (both && exact_enters == (events[k].crossing == Crossing::enter)) {
      const double error = as_double(magnitude(Quad(events[k].t) - expected.t[i]));
      if (std::isfinite(events[k].tau) && error <= events[k].tau) {
        if (events[k].tau > 0) tally.worst = std::max(tally.worst, error / events[k].tau);
        ++i, ++k;
        continue;
      }
      if (is_along && trial.is_on_surface((Quad(events[k].t) + expected.t[i]) / 2)) {
        ++tally.disagreements, ++i, ++k;
        continue;
      }
    }
    ++tally.disagreements;
    if (k + 1 < events.size() &&
        (events[k + 1].t - events[k].t <= std::max(events[k].tau, events[k + 1].tau) ||
         (is_along && trial.is_on_surface((Quad(events[k].t) + events[k + 1].t) / 2)))) {
      k += 2;
    } else if (i + 1 < expected.t.size() &&
               trial.is_on_surface((expected.t[i] + expected.t[i + 1]) / 2)) {
      i += 2;
    } else {
      auto failure = ::testing::AssertionFailure() << "no match for";
      if (i < expected.t.size()) failure << " exact " << i << ", t " << as_double(expected.t[i]);
      if (k < events.size())
        failure << ", event " << k << ", t " << events[k].t << " tau " << events[k].tau;
      return failure;
    }
  }
  return ::testing::AssertionSuccess();
}

/// A line along an asymptote to within rounding may lose the crossing that is further away, and
/// both when they are far.
inline ::testing::AssertionResult match_either(const Trial<Quadric>& trial,
                                               const EventBuffer& events, Crossings expected,
                                               Tally& tally) {
  const auto result = match(trial, events, expected, tally);
  const ExactLine& line = trial.exact_line;
  if (result || !is_asymptotic(trial.kind, line, trial.rounding)) return result;
  ++tally.disagreements;
  const bool all_are_lost = std::ranges::all_of(
      expected.t, [&](Quad t) { return is_lost(trial.kind, line, t, trial.rounding); });
  if (events.empty() && all_are_lost) {
    const Quad nearest = -dot(line.origin, line.direction) / dot(line.direction, line.direction);
    const bool inside = depth(trial.kind, line.at(nearest)) > 0;
    const bool is_decided = inside == events.inside_at_start() || trial.is_on_surface(nearest);
    return is_decided ? ::testing::AssertionSuccess() : result;
  }
  if (expected.t.empty()) return result;
  if (magnitude(expected.t.front()) > magnitude(expected.t.back())) {
    expected.t.erase(expected.t.begin());
    expected.inside_at_start = !expected.inside_at_start;
  } else {
    expected.t.pop_back();
  }
  const auto without = match(trial, events, expected, tally);
  return without ? without : result;
}
template <typename Kind>
::testing::AssertionResult match_either(const Trial<Kind>& trial, const EventBuffer& events,
                                        const Crossings& expected, Tally& tally) {
  return match(trial, events, expected, tally);
}

template <typename Kind>
::testing::AssertionResult check(const Trial<Kind>& trial, const EventBuffer& events,
                                 Tally& tally) {
  const Crossings expected = crossings(trial.kind, trial.exact_line);
  bool inside = events.inside_at_start();
  const double d = length(trial.line.direction);
  for (std::size_t k = 0; k < events.size(); ++k) {
    const Event& e = events[k];
    if ((e.crossing == Crossing::leave) != inside || (k > 0 && !(events[k - 1].t < e.t))) {
      return ::testing::AssertionFailure() << "events do not alternate";
    }
    inside = !inside;
    tally.relative_taus.push_back(e.tau * d / (length(trial.line.origin) + d * std::abs(e.t)));
  }
  events.empty() ? ++tally.misses : ++tally.hits;
  const auto result = match_either(trial, events, expected, tally);
  if (result) return result;
  return ::testing::AssertionFailure()
         << result.message() << "; " << events.size() << " events, " << expected.t.size()
         << " expected; " << describe(trial.kind) << "; origin" << words_of(trial.line.origin)
         << " direction" << words_of(trial.line.direction);
}

template <typename Kind>
double distance_scale(const Kind& kind, Vec3d origin) {
  const Box3d box = bounds(kind);
  return length(origin - reference_of(kind)) + (box.bounded() ? length(box.extent()) : 0.0);
}

/// Random and hostile solids of one kind on as many lines, as they are stated.
template <typename Kind>
Tally try_lines(std::uint64_t seed, int lines) {
  lapidary::test::Random random(seed);
  Tally tally;
  EventBuffer events;
  for (int i = 0; i < lines; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const Kind kind = hostile::make<Kind>(setting, random);
    const Line line = hostile::line_at(kind, setting, random);
    intervals(Solid(kind), line, events);
    const Trial<Kind> trial{kind, line, exact_line(line), distance_scale(kind, line.origin),
                            64 * unit_roundoff};
    const auto result = check(trial, events, tally);
    EXPECT_TRUE(result) << "line " << i;
    if (!result) break;
  }
  EXPECT_GT(tally.hits, lines / 8);
  return tally;
}

/// The same under maps that people write.
template <typename Kind>
Tally try_placed_lines(std::uint64_t seed, int lines) {
  lapidary::test::Random random(seed);
  Tally tally;
  EventBuffer events;
  for (int i = 0; i < lines; ++i) {
    hostile::Setting setting;
    setting.snapped = random.index(3) == 0;
    const Kind kind = hostile::make<Kind>(setting, random);
    const Transform map = hostile::placement(random);
    const PlacedSolid placed(kind, map);
    const Line own = hostile::line_at(kind, setting, random);
    const Line line{map.point(own.origin), map.vector(own.direction)};
    intervals(placed, line, events);
    const ExactLine exact_own = before(map, line);
    const Vec3d origin{as_double(exact_own.origin.x), as_double(exact_own.origin.y),
                       as_double(exact_own.origin.z)};
    const double back = stretch_of(map.inverse());
    const double scale =
        distance_scale(kind, origin) + back * (length(line.origin) + length(map.offset()));
    const double condition = stretch_of(map) * back / 3;
    const Trial<Kind> trial{kind, line, exact_own, scale, 1024 * condition * unit_roundoff};
    const auto result = check(trial, events, tally);
    EXPECT_TRUE(result) << "line " << i << " space " << static_cast<int>(placed.space());
    if (!result) break;
  }
  EXPECT_GT(tally.hits, lines / 8);
  return tally;
}

}  // namespace lapidary::geometry::exact
