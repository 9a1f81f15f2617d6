#include "texture/mapping.h"

#include <cmath>

#include <gtest/gtest.h>

#include "math/constants.h"
#include "support/random.h"

namespace lapidary::texture {
namespace {

using test::Random;

constexpr Projection projections[] = {Projection::uv, Projection::object, Projection::planar,
                                      Projection::cylindrical, Projection::spherical};

void expect_near(Vec3d a, Vec3d b, double tolerance) {
  EXPECT_LT(length(a - b), tolerance)
      << a.x << ' ' << a.y << ' ' << a.z << " is not " << b.x << ' ' << b.y << ' ' << b.z;
}

TEST(Mapping, ProjectsAsItSays) {
  const auto at = [](Projection projection, Vec3d p) {
    return place_of(projection, {.p = p, .uv = {0.3, 0.4}}).p;
  };
  expect_near(at(Projection::uv, {1, 2, 3}), {0.3, 0.4, 0}, 1e-15);
  expect_near(at(Projection::object, {1, 2, 3}), {1, 2, 3}, 1e-15);
  expect_near(at(Projection::planar, {1, 2, 3}), {1, 2, 0}, 1e-15);
  expect_near(at(Projection::cylindrical, {0, 5, 3}), {0.25, 3, 0}, 1e-15);
  expect_near(at(Projection::cylindrical, {0, -5, 3}), {0.75, 3, 0}, 1e-15);
  expect_near(at(Projection::spherical, {-1, 0, 0}), {0.5, 0.5, 0}, 1e-15);
  expect_near(at(Projection::spherical, {3, 0, 3}), {0, 0.75, 0}, 1e-15);
  expect_near(at(Projection::spherical, {0, 0, -2}), {0, 0, 0}, 1e-15);
}

TEST(Mapping, ABoxIsReadUprightFromOutside) {
  // Seen from outside with z up, u goes to the right.
  const auto u_direction = [](std::size_t axis, Vec3d normal) {
    const Place origin = box_place(axis, {.normal = normal});
    Vec3d direction;
    for (std::size_t i = 0; i < 3; ++i) {
      Vec3d step;
      step[i] = 1;
      direction[i] = box_place(axis, {.p = step, .normal = normal}).p.x - origin.p.x;
    }
    return direction;
  };
  for (const Vec3d normal : {Vec3d{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}) {
    const std::size_t axis = normal.x != 0 ? 0 : 1;
    EXPECT_EQ(u_direction(axis, normal), cross(Vec3d{0, 0, 1}, normal));
  }
  EXPECT_EQ(u_direction(2, {0, 0, 1}), (Vec3d{1, 0, 0}));
  EXPECT_EQ(u_direction(2, {0, 0, -1}), (Vec3d{-1, 0, 0}));
}

// A pattern's coordinates, and what a footprint covers of them, as differences of nearby places
// say.
TEST(Mapping, RepeatsAndShiftsWhatIsFlat) {
  Random random(21);
  for (const Projection projection : projections) {
    const Mapping plain{projection};
    const Mapping tiles{.projection = projection, .repeats = {6, -2.5}, .shift = {0.3, 0.1}};
    for (int i = 0; i < 50; ++i) {
      Lookup lookup{.p = random.direction() * 2.0, .uv = {random.uniform(), random.uniform()}};
      lookup.dpdx = random.direction() * 1e-3;
      lookup.duvdx = {1e-3, 2e-3};
      const auto place = [](const Mapping& mapping, const Lookup& at) {
        Place found;
        mapped(mapping, at, [&](const Place& p) { return found = p, 0.0f; });
        return found;
      };
      const Place before = place(plain, lookup), after = place(tiles, lookup);
      if (projection == Projection::object) {
        EXPECT_EQ(after.p, before.p);
        continue;
      }
      expect_near(after.p, {6 * (before.p.x - 0.3), -2.5 * (before.p.y - 0.1), 0}, 1e-12);
      expect_near(after.dx, {6 * before.dx.x, -2.5 * before.dx.y, 0}, 1e-12);
    }
  }
  // All around a ball, six times as often: from one copy to the next is a sixth of a turn.
  const Mapping six{.projection = Projection::spherical, .repeats = {6, 1}};
  const auto u = [&](double turns) {
    const double phi = 2.0 * pi * turns;
    double found = 0.0;
    mapped(six, {.p = {std::cos(phi), std::sin(phi), 0.2}},
           [&](const Place& p) { return found = p.p.x, 0.0f; });
    return found;
  };
  EXPECT_NEAR(u(0.2 + 1.0 / 6.0) - u(0.2), 1.0, 1e-12);
}

TEST(Mapping, SidesOfABoxBlend) {
  using Weights = std::array<float, 3>;
  EXPECT_EQ(box_weights({0, -1, 0}, 0.2), (Weights{0, 1, 0}));
  EXPECT_EQ(box_weights({0.9, 0.1, 0.1}, 0.2), (Weights{1, 0, 0}));
  EXPECT_EQ(box_weights({0.70, 0.71, 0}, 0.0), (Weights{0, 1, 0}));
  const auto [x, y, z] = box_weights(normalize(Vec3d{1, -1, 1}), 0.5);
  EXPECT_NEAR(x, 1.0f / 3, 1e-6f);
  EXPECT_NEAR(y, 1.0f / 3, 1e-6f);
  EXPECT_NEAR(z, 1.0f / 3, 1e-6f);
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const auto w = box_weights(random.direction(), random.uniform());
    EXPECT_NEAR(w[0] + w[1] + w[2], 1.0f, 1e-6f);
  }
}

TEST(Mapping, FootprintsAreTheDerivatives) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    const Projection projection = projections[random.index(5)];
    Lookup lookup;
    lookup.p = random.direction() * random.uniform(0.5, 3);
    if (std::hypot(lookup.p.x, lookup.p.y) < 0.2 || std::abs(lookup.p.y) < 0.01) continue;
    lookup.uv = random.uniform2();
    lookup.dpdx = random.direction() * 1e-4;
    lookup.dpdy = random.direction() * 1e-4;
    lookup.duvdx = random.uniform2() * 1e-4;
    lookup.duvdy = random.uniform2() * 1e-4;
    const auto moved = [&](double a, double b) {
      Lookup there = lookup;
      there.p += lookup.dpdx * a + lookup.dpdy * b;
      there.uv = there.uv + lookup.duvdx * a + lookup.duvdy * b;
      return place_of(projection, there).p;
    };
    const Place place = place_of(projection, lookup);
    expect_near(place.dx, moved(0.5, 0) - moved(-0.5, 0), 1e-8);
    expect_near(place.dy, moved(0, 0.5) - moved(0, -0.5), 1e-8);
  }
}

TEST(Mapping, FootprintsGoAcrossTheSeam) {
  for (const Projection projection : {Projection::cylindrical, Projection::spherical}) {
    const Place place = place_of(projection, {.p = {2, -1e-9, 0}, .dpdx = {0, 0.1, 0}});
    EXPECT_NEAR(place.dx.x, 0.1 / (4 * pi), 1e-8);
  }
}

TEST(Mapping, StandsAnyLookup) {
  Random random(3);
  const auto hostile = [&] {
    if (random.uniform() < 0.2) return 0.0;
    return (random.uniform() < 0.5 ? -1 : 1) * random.magnitude(-300, 150);
  };
  const auto vector = [&] { return Vec3d{hostile(), hostile(), hostile()}; };
  for (int i = 0; i < 20000; ++i) {
    const Lookup lookup{vector(),
                        random.direction(),
                        vector(),
                        vector(),
                        {hostile(), hostile()},
                        {hostile(), hostile()},
                        {hostile(), hostile()}};
    for (const Projection projection : projections) {
      const Place place = place_of(projection, lookup);
      EXPECT_TRUE(is_finite(place.p) && is_finite(place.dx) && is_finite(place.dy));
    }
  }
}

}  // namespace
}  // namespace lapidary::texture
