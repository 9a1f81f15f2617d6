#pragma once

#include <cmath>

namespace lapidary {

/// A value with its derivative.
struct ValueAndSlope {
  double value, slope;
};

/// An interval at whose ends a function has different signs: that at `low` is given.
struct Bracket {
  double low, high;
  bool is_negative_at_low;
};

/// A root of f in the bracket, by Newton's method from `start`, or by bisection wherever that
/// leaves the bracket or does not halve its steps. `f` returns a ValueAndSlope and need not be
/// smooth. Ends where f is 0, with a Newton step of at most `resolution`, whose square about is the
/// accuracy, or where bisection has no double left to try. It takes many steps when rounding moves
/// a Newton step by more than the resolution, unless f returns 0 for what is lost in rounding.
template <typename F>
double bracketed_root(const F& f, Bracket bracket, double start, double resolution) {
  double x = start, last_step = bracket.high - bracket.low;
  for (;;) {
    const ValueAndSlope at = f(x);
    if (at.value == 0.0) return x;
    ((at.value < 0.0) == bracket.is_negative_at_low ? bracket.low : bracket.high) = x;
    const double newton = x - at.value / at.slope, step = std::abs(newton - x);
    const bool is_newton = newton > bracket.low && newton < bracket.high && step <= 0.5 * last_step;
    const double next = is_newton ? newton : 0.5 * (bracket.low + bracket.high);
    if (is_newton && step <= resolution) return next;
    if (!is_newton && !(next > bracket.low && next < bracket.high)) return next;
    last_step = std::abs(next - x);
    x = next;
  }
}

}  // namespace lapidary
