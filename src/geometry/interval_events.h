#pragma once

#include <array>
#include <cassert>
#include <cstdint>

#include "math/vec.h"

namespace lapidary::geometry {

/// A line p(t) = origin + t direction, t over all reals; the direction has any length but zero,
/// and t is in its units.
struct Line {
  Vec3d origin;
  Vec3d direction;

  Vec3d at(double t) const { return origin + direction * t; }
};

/// Which smooth piece of a solid's boundary: a box has six, a cylinder three (side, from cap,
/// to cap), a sphere one. Numbered from 0 by each solid.
using Patch = std::uint16_t;

enum class Crossing : std::uint8_t { enter, leave };

/// A place where a line crosses the boundary of a solid.
struct Event {
  double t = 0;
  double tau =
      0;  ///< |t - exact t| <= tau for the solid as stated in doubles (running error analysis)
  Patch patch = 0;
  Crossing crossing = Crossing::enter;
};

/// The events of one solid on one line, in ascending t with alternating crossings.
///
/// `inside_at_start` says whether t = -infinity is inside: half-spaces and complements have an odd
/// number of events. Grows without allocation up to `capacity`, which is enough for every solid
/// whose boundary a line crosses a bounded number of times.
class EventBuffer {
 public:
  static constexpr std::size_t capacity = 8;

  void clear() { count_ = 0, inside_at_start_ = false; }
  void set_inside_at_start(bool inside) { inside_at_start_ = inside; }
  bool inside_at_start() const { return inside_at_start_; }
  void push(const Event& e) {
    assert(count_ < capacity);
    events_[count_++] = e;
  }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const Event& operator[](std::size_t i) const { return events_[i]; }
  const Event* begin() const { return events_.data(); }
  const Event* end() const { return events_.data() + count_; }

 private:
  std::array<Event, capacity> events_;
  std::size_t count_ = 0;
  bool inside_at_start_ = false;
};

}  // namespace lapidary::geometry
