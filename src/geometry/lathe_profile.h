#pragma once

#include <cstdint>

#include "geometry/inline_buffer.h"
#include "geometry/lathe_data.h"
#include "geometry/profile_line.h"
#include "math/bracketed_root.h"

/// In the profile a line is one branch of a hyperbola, which may have come down to a straight line,
/// and to its left or right is every corner of the polygon: outer corners are closer to the axis
/// than the line is where it passes their height. Both edges at a corner go by the same answer, and
/// by the same place on the line, found once: so around every loop there are as many edges from
/// outer to inner as the other way, whatever rounding made of the answers. An edge between
///     an outer and an inner corner   is crossed once,
///     two inner ones                 never, as rho is convex along the line,
///     two outer ones                 twice or never, once on each side of where it is closest.
/// Which of these is an entry follows from the same answers, so that entries and exits balance;
/// counting them along the line, inside is where there were more entries. Crossings are confined to
/// where the line passes the heights of their edge, so that those of a chain of edges that rises or
/// falls are in order exactly, and others out of order by no more than their bounds.
///
/// Where the line runs along an edge within rounding, the corners at both ends are on the side that
/// they would be on after tie_shift, which is the same for both. A corner on the axis is outer,
/// always. Edges on the axis are between such corners, and never crossed.
namespace lapidary::geometry {

/// How the line passes a corner of the polygon.
struct Passing {
  double s;
  bool is_outer;    ///< the corner is closer to the axis than the line
  bool is_certain;  ///< beyond rounding
};

/// A crossing of an edge of the polygon, at the parameter m + s.
struct ProfileCrossing {
  double s;
  std::uint32_t edge;
  bool enters;
};
using ProfileCrossings = InlineBuffer<ProfileCrossing, 16>;

/// One line against the polygon of one lathe.
class LatheProfile {
 public:
  LatheProfile(const Lathe::Data& data, const ProfileLine& line) : data_(data), c_(line) {}

  /// Adds all crossings, in any order, as many entries as exits.
  void find(ProfileCrossings& found) const;
  /// Bounds |s - exact s|.
  double tau(const ProfileCrossing& crossing) const;

 private:
  /// The distance from the edge's straight line, greater further from the axis; with bounds on its
  /// error by rounding alone, and in all.
  ///
  /// Error analysis: the point is off by `error` (see ProfileLine), the unit normal by 5 u relative
  /// in each component (differences 1, length 3, quotient 1), and the differences from the corner,
  /// products and sum have 3 u more.
  struct Distance {
    double value, rounding, error, slope;
  };
  Distance distance(std::uint32_t edge, double s) const;

  Passing pass(std::uint32_t corner) const;
  bool is_on_line(const ProfileLine::Point& p, double difference) const;
  bool runs_along_edge(std::uint32_t corner) const;
  bool is_outer_after_shift(const ProfileLine::Point& p) const;
  bool is_apart(const Lathe::Data::Node& node) const;
  void cross(std::uint32_t edge, const Passing& from, const Passing& to,
             ProfileCrossings& found) const;
  void cross_twice(std::uint32_t edge, double low, double high, ProfileCrossings& found) const;
  double closest(std::uint32_t edge) const;
  double root(std::uint32_t edge, const Bracket& bracket) const;
  double guess(std::uint32_t edge, const Bracket& bracket) const;
  double reach(std::uint32_t edge, double s, double direction) const;
  double reach_past(std::uint32_t edge, std::uint32_t corner, double tau) const;
  bool hangs_on(const ProfileCrossing& crossing, const Passing& corner) const;

  const Lathe::Data& data_;
  const ProfileLine& c_;
};

}  // namespace lapidary::geometry
