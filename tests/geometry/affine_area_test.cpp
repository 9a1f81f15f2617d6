#include "geometry/affine_area.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::geometry {
namespace {

Mat3 diagonal(double a, double b, double c) {
  return Transform::scaling({a, b, c}).linear();
}

/// Length of a closed curve by the trapezoidal rule, which converges exponentially for it.
double perimeter_by_quadrature(Vec3d a, Vec3d b) {
  constexpr int n = 20000;
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    const double phi = 2.0 * pi * i / n;
    sum += length(b * std::cos(phi) - a * std::sin(phi));
  }
  return sum * 2.0 * pi / n;
}

TEST(CarlsonRg, AgreesWithClosedForms) {
  EXPECT_DOUBLE_EQ(carlson_rg(4.0, 4.0, 4.0), 2.0);
  EXPECT_DOUBLE_EQ(carlson_rg(0.0, 9.0, 9.0), 0.75 * pi);
  EXPECT_DOUBLE_EQ(carlson_rg(9.0, 0.0, 9.0), 0.75 * pi);
  for (const double k : {0.0, 0.1, 0.5, 0.9, 0.999, 0.999999}) {
    const double complete = std::comp_ellint_2(k);  // E(k) = 2 R_G(0, 1 - k^2, 1)
    EXPECT_NEAR(2.0 * carlson_rg(0.0, (1.0 - k) * (1.0 + k), 1.0) / complete, 1.0, 5e-14) << k;
  }
}

TEST(EllipsoidArea, AgreesWithSpheroids) {
  EXPECT_NEAR(ellipsoid_area(diagonal(3, 3, -3)), 36 * pi, 1e-12);
  for (const double c : {1e-6, 0.01, 0.5, 0.99}) {  // oblate
    const double e = std::sqrt((1 - c) * (1 + c));
    const double expected = 2 * pi * (1 + c * c / e * std::atanh(e));
    EXPECT_NEAR(ellipsoid_area(diagonal(1, c, 1)) / expected, 1.0, 1e-13) << c;
  }
  for (const double c : {1.01, 2.0, 100.0, 1e6}) {  // prolate
    const double e = std::sqrt((1 - 1 / c) * (1 + 1 / c));
    const double expected = 2 * pi * (1 + c / e * std::atan2(e, 1 / c));
    EXPECT_NEAR(ellipsoid_area(diagonal(c, 1, 1)) / expected, 1.0, 1e-13) << c;
  }
}

TEST(EllipsoidArea, DoesNotDependOnOrientation) {
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d axes{random.magnitude(-3, 3), random.magnitude(-3, 3), random.magnitude(-3, 3)};
    const Vec3d axis = random.direction();
    const Transform a = Transform::rotation(axis, random.uniform(0, 6));
    const Transform b = Transform::rotation({1, 2, -1}, random.uniform(0, 6));
    const double expected = ellipsoid_area(diagonal(axes.x, axes.y, axes.z));
    const Mat3 turned = (a * Transform::scaling(axes) * b).linear();
    ASSERT_NEAR(ellipsoid_area(turned) / expected, 1.0, 1e-9);
  }
}

TEST(EllipsePerimeter, AgreesWithQuadrature) {
  EXPECT_NEAR(ellipse_perimeter({0, 2, 0}, {0, 0, 2}), 4 * pi, 1e-13);
  test::Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Vec3d a = random.direction() * random.magnitude(-1, 1);
    const Vec3d b = random.direction() * random.magnitude(-1, 1);
    if (length(cross(a, b)) < 0.01 * length(a) * length(b)) continue;
    ASSERT_NEAR(ellipse_perimeter(a, b) / perimeter_by_quadrature(a, b), 1.0, 1e-12);
  }
}

}  // namespace
}  // namespace lapidary::geometry
