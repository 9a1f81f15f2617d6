#pragma once

namespace lapidary {

/// Weight of a sample drawn with density `chosen` that another technique could have drawn with
/// density `other`. Densities are of the same measure, >= 0; an infinite `chosen` (a point light, a
/// mirror) gets 1 as long as `other` is finite, a `chosen` of 0 gets 0.
/// Source: Veach 1997, "Robust Monte Carlo Methods for Light Transport Simulation", eq. 9.8.
constexpr double balance_heuristic(double chosen, double other) {
  return chosen > 0.0 ? 1.0 / (1.0 + other / chosen) : 0.0;
}

/// The same with exponent 2; the ratio first, so that nothing overflows that need not.
/// Source: Veach 1997, eq. 9.11.
constexpr double power_heuristic(double chosen, double other) {
  if (!(chosen > 0.0)) return 0.0;
  const double ratio = other / chosen;
  return 1.0 / (1.0 + ratio * ratio);
}

}  // namespace lapidary
