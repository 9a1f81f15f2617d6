#include "support/statistics.h"

#include <algorithm>

#include <fmt/format.h>

namespace lapidary::test {

ZTestResult z_test(const RunningMean& measured, double expected, double k, double tolerance) {
  const double error = measured.standard_error();
  const double excess = std::max(0.0, std::abs(measured.mean() - expected) - tolerance);
  // A constant has no spread: it agrees exactly or not at all.
  const double z = excess == 0.0 ? 0.0 : excess / error;
  return {measured.count() > 0 && z <= k, z,
          fmt::format("measured {:.9g} +- {:.3g} ({} samples), expected {:.9g}: {:.2f} standard "
                      "errors, {} allowed",
                      measured.mean(), error, measured.count(), expected, z, k)};
}

}  // namespace lapidary::test
