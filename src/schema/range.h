#pragma once

#include <string>

#include "math/constants.h"

namespace lapidary::schema {

/// Which numbers a parameter takes; for vectors, each component. All are finite.
struct Range {
  enum class End { closed, open };
  double min = -infinity;
  double max = infinity;
  End min_end = End::closed;
  End max_end = End::closed;

  constexpr bool contains(double x) const {
    return (min_end == End::closed ? x >= min : x > min) &&
           (max_end == End::closed ? x <= max : x < max);
  }
  constexpr bool unlimited() const { return min == -infinity && max == infinity; }
  /// "greater than 0", "at least 1", "from 0 to 1", "greater than 0 and less than 180".
  std::string text() const;
};

inline constexpr Range any_number{};
inline constexpr Range positive{.min = 0, .min_end = Range::End::open};
inline constexpr Range non_negative{.min = 0};
inline constexpr Range unit_interval{.min = 0, .max = 1};

}  // namespace lapidary::schema
