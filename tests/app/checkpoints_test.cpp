#include "app/checkpoints.h"

#include <gtest/gtest.h>

namespace lapidary::app {
namespace {

// At most 2 % of the time by default, whatever a checkpoint costs.
TEST(Checkpoints, CostLittleByDefault) {
  for (const double cost : {0.0, 0.01, 1.0, 1.2, 5.0, 60.0, 1000.0}) {
    EXPECT_GE(Checkpoints::default_interval(cost), 60.0);
    EXPECT_LE(cost, 0.02 * Checkpoints::default_interval(cost) * (1 + 1e-12));
  }
}

}  // namespace
}  // namespace lapidary::app
