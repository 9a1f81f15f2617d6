#include "math/frame.h"

#include <random>

#include <gtest/gtest.h>

namespace lapidary {
namespace {

TEST(Frame, IsRightHandedAndOrthonormalForEveryNormal) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> gauss;
  std::vector<Vec3d> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {1e-9, 0, -1}};
  for (int i = 0; i < 1000; ++i) normals.push_back({gauss(random), gauss(random), gauss(random)});
  for (const Vec3d& n : normals) {
    const Frame f = Frame::from_normal(normalize(n));
    EXPECT_NEAR(length(f.tangent), 1.0, 1e-15);
    EXPECT_NEAR(length(f.bitangent), 1.0, 1e-15);
    EXPECT_NEAR(dot(f.tangent, f.bitangent), 0.0, 1e-15);
    EXPECT_NEAR(length(cross(f.tangent, f.bitangent) - f.normal), 0.0, 1e-15);
    const Vec3d v{0.3, -2.0, 5.0};
    EXPECT_NEAR(length(f.to_world(f.to_local(v)) - v), 0.0, 1e-14);
  }
}

}  // namespace
}  // namespace lapidary
