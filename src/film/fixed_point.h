#pragma once

#include <cmath>
#include <cstdint>

namespace lapidary::film {

/// Converts values to 64-bit fixed point, whose sums are exact and therefore have no order: any
/// number of threads, machines or interruptions gives the same bits.
///
/// One unit is 2^-32 of the scale's `one`. A value beyond 2^28 of them is saturated, one that is
/// not finite becomes 0; the caller counts and reports both.
class FixedScale {
 public:
  static constexpr double limit = 0x1p28;

  /// `one` > 0: the value that becomes 2^32.
  explicit FixedScale(double one = 1.0) : to_units_(0x1p32 / one), to_value_(one * 0x1p-32) {}

  enum class Outcome { exact, saturated, not_finite };
  struct Fixed {
    std::int64_t units;
    Outcome outcome;
  };

  Fixed fixed(double value) const {
    const double units = value * to_units_;
    constexpr double most = limit * 0x1p32;
    if (std::abs(units) < most) {
      return {static_cast<std::int64_t>(std::nearbyint(units)), Outcome::exact};
    }
    if (!std::isfinite(units)) return {0, Outcome::not_finite};
    return {static_cast<std::int64_t>(std::copysign(most, units)), Outcome::saturated};
  }

  double value(std::int64_t units) const { return static_cast<double>(units) * to_value_; }

 private:
  double to_units_;
  double to_value_;
};

/// a + b, held at the ends of the range.
inline std::int64_t saturating_add(std::int64_t a, std::int64_t b) {
  std::int64_t sum = 0;
  if (!__builtin_add_overflow(a, b, &sum)) return sum;
  return a < 0 ? INT64_MIN : INT64_MAX;
}

}  // namespace lapidary::film
