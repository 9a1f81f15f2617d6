#include <gtest/gtest.h>

#include "transport/probe.h"

// A camera may stand in glass or water.

namespace lapidary::test {
namespace {

// From under water all of the sky is in a cone of 2 asin(1 / 1.33) = 97.2 degrees, brighter by
// 1.33^2 and dimmed by what the surface reflects; around it is what the water is in.
TEST(UnderWater, TheSkyIsInSnellsWindow) {
  const double n = 1.33;
  TinyScene tiny;
  tiny.sky(1.0);
  tiny.add(geometry::HalfSpace{}, glass(n));
  tiny.add(geometry::HalfSpace{{0, 0, -5}, {0, 0, 1}}, matte(0.0));
  const scene::Scene scene = tiny.build();
  const double edge = std::asin(1 / n);
  EXPECT_NEAR(degrees(edge), 48.75, 0.01);
  const auto towards = [&](double angle) {
    return radiance(scene, ray({0.3, 0.2, -1}, {std::sin(angle), 0, std::cos(angle)}),
                    {{16}, 1024, 64});
  };
  for (const double share : {0.0, 0.5, 0.9, 0.995}) {
    const double angle = share * edge, out = std::asin(n * std::sin(angle));
    const double ci = std::cos(angle), co = std::cos(out);
    const double rs = (n * ci - co) / (n * ci + co), rp = (ci - n * co) / (ci + n * co);
    expect_radiance(towards(angle), n * n * (1 - 0.5 * (rs * rs + rp * rp)));
  }
  EXPECT_EQ(towards(1.001 * edge).mean(), 0.0);
  EXPECT_EQ(towards(radians(80)).mean(), 0.0);
  EXPECT_EQ(towards(radians(120)).mean(), 0.0);
}

// And so a panorama from there is bright in the rows above latitude 90 - 48.75, and in no other.
TEST(UnderWater, APanoramaIsBrightAboveItsLatitudeAlone) {
  const double n = 1.33;
  TinyScene tiny;
  tiny.sky(1.0);
  tiny.add(geometry::HalfSpace{}, glass(n));
  tiny.add(geometry::HalfSpace{{0, 0, -5}, {0, 0, 1}}, matte(0.0));
  description::Panorama around;
  around.view = {{0, 0, -1}, {0, 1, -1.5}, {0, 0, 1}};
  tiny.description.camera.emplace(description::Camera{around, {}});
  const scene::Scene scene = tiny.build();
  const double limit = 90 - degrees(std::asin(1 / n));
  for (int i = 0; i < 360; ++i) {
    const double latitude = 89.75 - 0.5 * i;
    const auto seen = camera::generate_ray(scene.camera(), {{0.37, (90 - latitude) / 180}, {}});
    const double mean = radiance(scene, *seen, {{16}, 8, 16}).mean();
    EXPECT_EQ(mean > 0.0, latitude > limit) << latitude;
  }
}

}  // namespace
}  // namespace lapidary::test
