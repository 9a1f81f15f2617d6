#include <gtest/gtest.h>

#include "texture/texture.h"
#include "transport/probe.h"

namespace lapidary::test {
namespace {

// Lights whose emission varies over their surface. A board of squares gives what its bright
// squares would give as lights of their own.

/// Squares in (u, v) times `count`, by what moves with the surface: cubes in the object's space.
description::MaterialPtr squares(double first, double second, double radiance) {
  description::Emissive emissive;
  emissive.emission = {description::Quantity::radiance, grey(radiance)};
  emissive.pattern = std::make_shared<const texture::Texture>(texture::Texture{
      texture::Checker{{texture::Color(grey(first)), texture::Color(grey(second))}, {}}});
  return material(emissive);
}

RunningMean seen_on_ground(const TinyScene& tiny) {
  const scene::Scene scene = tiny.build();
  return radiance(scene, ray_to({-1, -2, 1.5}, {0, 0, 0}), {.pixels = 64, .samples = 256});
}

TinyScene ground() {
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(1.0));
  return tiny;
}

/// Two by two squares of side 1 under z = 2, their front down.
const geometry::Rectangle board{{-1, -1, 2.5}, {0, 2, 0}, {2, 0, 0}};

TEST(PatternLight, GivesWhatItsSquaresGive) {
  TinyScene patterned = ground(), single = ground();
  patterned.add(board, squares(1.0, 0.25, 3.0));
  // z is in the third layer of cubes, so the squares with x y > 0 are those of even sum.
  single.add(geometry::Rectangle{{-1, -1, 2.5}, {0, 1, 0}, {1, 0, 0}}, lamp(3.0))
      .add(geometry::Rectangle{{0, 0, 2.5}, {0, 1, 0}, {1, 0, 0}}, lamp(3.0))
      .add(geometry::Rectangle{{-1, 0, 2.5}, {0, 1, 0}, {1, 0, 0}}, lamp(0.75))
      .add(geometry::Rectangle{{0, -1, 2.5}, {0, 1, 0}, {1, 0, 0}}, lamp(0.75));
  const RunningMean a = seen_on_ground(patterned), b = seen_on_ground(single);
  // Both are estimates: 4 standard errors of the difference, missed once in 16,000 seeds.
  EXPECT_NEAR(a.mean(), b.mean(), 4.0 * std::hypot(a.standard_error(), b.standard_error()));
  EXPECT_LT(a.standard_error(), 0.01 * a.mean());
}

TEST(PatternLight, IsSeenAsItIs) {
  TinyScene tiny = ground();
  tiny.add(board, squares(1.0, 0.25, 3.0));
  const scene::Scene scene = tiny.build();
  const auto seen = [&](double x, double y) {
    return radiance(scene, ray_to({x, y, 0.5}, {x, y, 2.5}), {.pixels = 4, .samples = 4}).mean();
  };
  EXPECT_NEAR(seen(0.5, 0.5), 3.0, 1e-6);
  EXPECT_NEAR(seen(-0.5, 0.5), 0.75, 1e-6);
}

// A mesh light's own triangles may stand between a point drawn on it and what it lights.
TEST(PatternLight, OfAMeshIsNotSeenThroughItself) {
  const auto plate = [](double z, double half) {
    const auto corner = [&](double x, double y) {
      return Vec3f{static_cast<float>(x * half), static_cast<float>(y * half),
                   static_cast<float>(z)};
    };
    return std::array<Vec3f, 4>{corner(-1, -1), corner(-1, 1), corner(1, 1), corner(1, -1)};
  };
  geometry::TriangleMesh two;
  for (const auto& corners : {plate(2.0, 1.0), plate(3.0, 1.0)}) {
    const auto first = static_cast<std::uint32_t>(two.positions.size());
    two.positions.insert(two.positions.end(), corners.begin(), corners.end());
    two.triangles.push_back({first, first + 1, first + 2});
    two.triangles.push_back({first, first + 2, first + 3});
  }
  TinyScene patterned = ground(), plain = ground();
  patterned.add_mesh(two, squares(1.0, 1.0, 2.0));
  plain.add_mesh(two, lamp(2.0));
  const RunningMean a = seen_on_ground(patterned), b = seen_on_ground(plain);
  EXPECT_NEAR(a.mean(), b.mean(), 4.0 * std::hypot(a.standard_error(), b.standard_error()));
  EXPECT_LT(a.standard_error(), 0.01 * a.mean());
}

}  // namespace
}  // namespace lapidary::test
