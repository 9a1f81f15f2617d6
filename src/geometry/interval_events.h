#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "math/constants.h"
#include "math/vec.h"

namespace lapidary::geometry {

/// The unit roundoff, a hair larger, so that a bound to first order in it also covers the terms of
/// second order and the rounding of the bound itself. Every tau is counted in this unit.
inline constexpr double rounding_unit = 0x1.0001p-53;

/// A line p(t) = origin + t direction, t over all reals; the direction has any length but zero,
/// and t is in its units.
///
/// A line that went through a transform is known only within rounding: the true point of parameter
/// t lies within `origin_error + |t| direction_error` of p(t). Error bounds of events include that.
/// Coordinates, lengths and their ratios are assumed within 1e-60 .. 1e60: squares must not
/// underflow.
struct Line {
  Vec3d origin;
  Vec3d direction;
  double origin_error = 0;
  double direction_error = 0;

  bool is_exact() const { return origin_error == 0.0 && direction_error == 0.0; }
  Vec3d at(double t) const { return origin + direction * t; }
  double error_at(double t) const { return origin_error + std::abs(t) * direction_error; }
};

/// Which smooth piece of a solid's boundary: a box has six, a cylinder three (side, from cap,
/// to cap), a sphere one, a mesh one for each triangle. Numbered from 0 by each solid.
using Patch = std::uint32_t;

enum class Crossing : std::uint8_t { enter, leave };

/// A place where a line crosses the boundary of a solid. Not initialised unless braced, so that
/// buffers of events cost nothing.
struct Event {
  double t;
  double tau;  ///< |t - exact t| <= tau for the solid as stated in doubles (running error analysis)
  Patch patch;
  Crossing crossing;
};

/// The events of one solid on one line, in ascending t with alternating crossings.
///
/// `inside_at_start` says whether t = -infinity is inside: half-spaces and complements have an odd
/// number of events. Most solids have few; a buffer that is used again allocates only when it meets
/// more events than ever before.
class EventBuffer {
 public:
  EventBuffer() {}  // NOLINT: not defaulted, so that EventBuffer{} does not clear the array either
  EventBuffer(const EventBuffer&) = delete;
  EventBuffer& operator=(const EventBuffer&) = delete;

  void clear() { count_ = 0, inside_at_start_ = false; }
  void set_inside_at_start(bool inside) { inside_at_start_ = inside; }
  bool inside_at_start() const { return inside_at_start_; }
  void push(const Event& e) {
    if (count_ == capacity_) grow();
    events_[count_++] = e;
  }
  void drop_last() { --count_; }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const Event& operator[](std::size_t i) const { return events_[i]; }
  Event& operator[](std::size_t i) { return events_[i]; }
  const Event* begin() const { return events_; }
  const Event* end() const { return events_ + count_; }
  Event* begin() { return events_; }
  Event* end() { return events_ + count_; }

 private:
  static constexpr std::size_t inline_capacity = 8;

  void grow();  // keeps the first `count_`

  std::size_t count_ = 0;
  std::size_t capacity_ = inline_capacity;
  bool inside_at_start_ = false;
  Event* events_ = few_.data();
  std::array<Event, inline_capacity> few_;
  std::vector<Event> many_;  ///< takes over from `few_` when that is full
};

/// A line that lies in a flat face, or runs along a curved one, to within rounding counts as
/// shifted by an infinitesimal amount in this fixed direction. So of two solids that share a face
/// exactly one is on the line's side, whatever the view. The direction lies in no plane that
/// scenes are made of (powers of the inverse plastic number).
inline constexpr Vec3d tie_shift{1.0, 0.7548776662466927, 0.5698402909980532};

/// Whether a line that lies in a face with this outward normal counts as inside.
inline bool counts_as_inside(Vec3d outward_normal) {
  return dot(outward_normal, tie_shift) < 0.0;
}

}  // namespace lapidary::geometry
