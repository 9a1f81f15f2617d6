#include <gtest/gtest.h>

#include "light/light_selector.h"
#include "light/light_tree_build.h"
#include "light/lights.h"
#include "support/chi_squared.h"

namespace lapidary::light {
namespace {

using lapidary::test::Random;
using test::white;

/// Walks through all numbers: each light must be chosen with the probability that is stated.
void expect_stated_probabilities(const LightSelector& selector, std::size_t lights,
                                 const LitPoint& to) {
  constexpr int steps = 20000;
  std::vector<double> chosen(lights);
  for (int i = 0; i < steps; ++i) {
    const auto choice = selector.choose(to, (i + 0.5) / steps);
    ASSERT_LT(choice.index, lights);
    EXPECT_EQ(choice.probability, selector.probability(to, choice.index));
    EXPECT_GE(choice.remainder, 0.0);
    EXPECT_LT(choice.remainder, 1.0);
    chosen[choice.index] += 1.0 / steps;
  }
  for (std::size_t i = 0; i < lights; ++i) {
    EXPECT_NEAR(chosen[i], selector.probability(to, i), 1.5 / steps * static_cast<double>(lights));
  }
}

TEST(LightSelector, ChoosesAmongAFewByWhatTheyCouldDo) {
  const std::vector<Light> lights{PointLight{{0, 0, 5}, white(3.0f)}, DiskLight({}, white()),
                                  PointLight{{}, white(0.0f)}, ConstantEnvironment{white(0.1f)}};
  const LightSelector selector(lights, 2.0);
  const Vec3d near_point{0, 0, 4.5}, behind_disk{0, 0, -1}, far{1e6, 0, 1};
  for (const Vec3d& p : {near_point, behind_disk, far}) {
    expect_stated_probabilities(selector, lights.size(), {p});
    EXPECT_EQ(selector.probability({p}, 2), 0.0) << "it is dark";
  }
  EXPECT_EQ(selector.probability({behind_disk}, 1), 0.0);
  EXPECT_GT(selector.probability({{0, 0, 1}}, 1), 0.0);
  EXPECT_GT(selector.probability({near_point}, 0), 0.9);
  EXPECT_GT(selector.probability({far}, 3), 0.99) << "only the sky reaches so far";
}

TEST(LightSelector, NeverLeavesOutALightThatReachesThePoint) {
  Random random(17);
  const RectangleLight wide({{-50, -50, 0}, {100, 0, 0}, {0, 100, 0}}, white());
  const std::vector<Light> lights{wide, PointLight{{0, 0, 3}, white(100.0f)}};
  const LightSelector selector(lights, 100.0);
  const Wavelengths w = Wavelengths::sample(0.5);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p{200 * random.uniform() - 100, 200 * random.uniform() - 100,
                  20 * random.uniform() - 10};
    const LightNumbers numbers{0.5, {random.uniform(), random.uniform()}};
    const auto sample = sample_illumination(lights[0], p, numbers, w);
    if (sample && !sample->L.is_zero()) {
      EXPECT_GT(selector.probability({p}, 0), 0.0);
    }
  }
}

TEST(Influence, OfAParallelogramHoldsItsLongDiagonal) {
  for (const double lean : {-1.5, 0.0, 1.5}) {
    const Influence all = influence(RectangleLight({{1, 2, 3}, {2, 0, 0}, {lean, 1, 0}}, white()));
    for (const Vec3d& corner :
         {Vec3d(1, 2, 3), Vec3d(3, 2, 3), Vec3d(1 + lean, 3, 3), Vec3d(3 + lean, 3, 3)}) {
      EXPECT_LE(length_squared(corner - all.center), all.radius_squared * (1 + 1e-15));
    }
  }
}

TEST(LightSelector, KeepsSpotsOutOfWhereTheyDoNotShine) {
  const SpotLight::Cone down{{0, 0, -1}, 0.2, 0.5};
  const std::vector<Light> lights{SpotLight({0, 0, 4}, down, white()),
                                  PointLight{{0, 0, 9}, white()}};
  const LightSelector selector(lights, 10.0);
  EXPECT_GT(selector.probability({{0, 0, 0}}, 0), 0.5);
  EXPECT_EQ(selector.probability({{0, 0, 5}}, 0), 0.0);
  EXPECT_EQ(selector.probability({{4, 0, 0}}, 0), 0.0);
}

TEST(LightSelector, ChoosesByPowerWhereAsked) {
  std::vector<Light> lights;
  for (int i = 0; i < 40; ++i) lights.push_back(PointLight{{}, white(static_cast<float>(i % 5))});
  const LightSelector selector(lights, 2.0, ChoiceRule::power);
  double total = 0;
  for (const Light& light : lights) total += power(light, 2.0);
  for (std::size_t i = 0; i < lights.size(); ++i) {
    EXPECT_NEAR(selector.probability({{1, 2, 3}}, i), power(lights[i], 2.0) / total, 1e-12);
  }
  expect_stated_probabilities(selector, lights.size(), {{1, 2, 3}});
}

/// `count` lights of all kinds that stand somewhere, small ones and large ones, some of them dark,
/// some of them in the same place.
std::vector<Light> crowd(std::size_t count, Random& random) {
  std::vector<Light> lights;
  const geometry::TriangleMesh roof = test::roof();
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d place{random.uniform(-8, 8), random.uniform(-8, 8), random.uniform(0, 4)};
    const Vec3d at = i % 11 == 0 ? Vec3d(1, 1, 1) : place;
    const Spectrum L = white(i % 13 == 0 ? 0.0f : static_cast<float>(random.magnitude(-3, 1)));
    const double size = random.magnitude(-3, 0);
    const Transform put = Transform::translation(at) * Transform::scaling({size, size, size});
    switch (i % 7) {
      case 0:
        lights.push_back(SphereLight(at, size, L));
        break;
      case 1:
        lights.push_back(RectangleLight({at, size * random.direction(), {0.1 * size, 0, size}}, L));
        break;
      case 2:
        lights.push_back(DiskLight({at, random.direction(), size}, L));
        break;
      case 3:
        lights.push_back(MeshLight(roof, put, L));
        break;
      case 4:
        lights.push_back(PointLight{at, L});
        break;
      case 5:
        lights.push_back(SpotLight(at, {random.direction(), 0.1, random.uniform(0.1, 1.5)}, L));
        break;
      default:
        lights.push_back(SolidLight(test::PlacedSolid(test::Box{}, put), L));
    }
  }
  return lights;
}

std::vector<Light> with_skies(std::vector<Light> lights) {
  lights.insert(lights.begin() + 3, DistantLight({{1, 1, 1}, 0.1}, white(0.02f)));
  lights.push_back(ConstantEnvironment{white(0.01f)});
  lights.push_back(ConstantEnvironment{white(0.0f)});
  return lights;
}

LitPoint lit_point(Random& random) {
  const Vec3d p{random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-1, 6)};
  return {p, random.uniform() < 0.3 ? Vec3d() : random.direction()};
}

TEST(ManyLights, HaveProbabilitiesThatSumToOne) {
  Random random(23);
  // All of them shine to all sides, so that there is no way into the dark.
  std::vector<Light> lights;
  for (int i = 0; i < 300; ++i) {
    lights.push_back(PointLight{{random.uniform(-8, 8), random.uniform(-8, 8), 3}, white()});
  }
  for (const auto& some : {lights, with_skies(lights)}) {
    const LightSelector selector(some, 10.0);
    for (int k = 0; k < 200; ++k) {
      const LitPoint to{lit_point(random).p};
      double sum = 0.0;
      for (std::size_t i = 0; i < some.size(); ++i) sum += selector.probability(to, i);
      EXPECT_NEAR(sum, 1.0, 1e-12);
    }
  }
}

// Of any kinds of light, together with the chance that none is chosen. 40 tests that share
// a false-alarm rate of 1e-6.
TEST(ManyLights, AreChosenAsOftenAsStated) {
  Random random(29);
  const std::vector<Light> lights = with_skies(crowd(90, random));
  const LightSelector selector(lights, 10.0);
  constexpr int tests = 40, samples = 20000;
  for (int k = 0; k < tests; ++k) {
    const LitPoint to = lit_point(random);
    std::vector<double> expected(lights.size() + 1), observed(lights.size() + 1);
    double sum = 0.0;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      sum += selector.probability(to, i);
      expected[i] = samples * selector.probability(to, i);
    }
    EXPECT_LT(sum, 1.0 + 1e-12);
    expected.back() = sum > 1.0 - 1e-9 ? 0.0 : samples * (1.0 - sum);
    for (int i = 0; i < samples; ++i) {
      const Choice choice = selector.choose(to, random.uniform());
      EXPECT_EQ(choice.probability,
                choice.probability > 0.0 ? selector.probability(to, choice.index) : 0.0);
      EXPECT_GE(choice.remainder, 0.0);
      EXPECT_LT(choice.remainder, 1.0);
      ++observed[choice.probability > 0.0 ? choice.index : lights.size()];
    }
    const auto result =
        lapidary::test::chi_squared_test(observed, expected, lapidary::test::sidak(1e-6, tests));
    EXPECT_TRUE(result.accepted) << result.message;
  }
}

TEST(ManyLights, AreNeverLeftOutWhereTheirLightArrives) {
  Random random(31);
  const std::vector<Light> lights = with_skies(crowd(200, random));
  const LightSelector selector(lights, 10.0);
  int arrived = 0;
  for (int k = 0; k < 300; ++k) {
    LitPoint to = lit_point(random);
    if (k % 10 == 0) to.p = {1, 1, 1};  // where lights crowd
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const LightNumbers numbers{random.uniform(), random.uniform2()};
      const auto sample = sample_illumination(lights[i], to.p, numbers, test::wavelengths());
      if (!sample || sample->L.is_zero() || dot(sample->wi, to.normal) < 0.0) continue;
      ++arrived;
      EXPECT_GT(selector.probability(to, i), 0.0) << "light " << i << " at " << k;
    }
  }
  EXPECT_GT(arrived, 10000);
}

// The nearest of equal lamps has the greatest chance, and lamps below the horizon have none.
TEST(ManyLights, AreChosenByWhereTheyAre) {
  std::vector<Light> lights;
  for (int i = 0; i < 1000; ++i) {
    lights.push_back(
        SphereLight({static_cast<double>(i), 0, i % 2 == 0 ? 1.0 : -1.0}, 0.1, white()));
  }
  const LightSelector selector(lights, 1000.0);
  const LitPoint floor{{500, 0, 0}, {0, 0, 1}};
  EXPECT_GT(selector.probability(floor, 500), 0.1) << "of power it would have 0.001";
  EXPECT_GT(selector.probability(floor, 500), 10 * selector.probability(floor, 520));
  EXPECT_EQ(selector.probability(floor, 501), 0.0);
  EXPECT_GT(selector.probability({floor.p}, 501), 0.0) << "without a normal, it counts";
}

// Bright narrow spots all around, none of which shines on the point: lamps have all the chances.
TEST(ManyLights, AreNotHiddenByBrightSpotsThatShinePast) {
  std::vector<Light> lights;
  for (int i = 0; i < 46; ++i) {
    const double a = 2.4 * i;
    const Vec3d at{8 * std::cos(a), 8 * std::sin(a), 5 + 0.1 * i};
    if (i % 8 == 0) {
      const double aim = 4 * a;
      lights.push_back(SpotLight(
          at, {normalize(Vec3d{std::cos(aim), std::sin(aim), 0} - at), 0.0, 0.05}, white(500)));
    } else {
      lights.push_back(SphereLight(at, 0.2, white()));
    }
  }
  const LightSelector selector(lights, 10.0);
  const LitPoint center{{0, 0, 0}, {0, 0, 1}};
  double of_lamps = 0.0;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const double probability = selector.probability(center, i);
    if (i % 8 == 0) {
      EXPECT_EQ(probability, 0.0) << i;
    } else {
      of_lamps += probability;
      EXPECT_GT(probability, 0.3 / 40) << i;
      EXPECT_LT(probability, 3.0 / 40) << i;
    }
  }
  EXPECT_NEAR(of_lamps, 1.0, 1e-12) << "the rest of all choices would be lost";
}

TEST(ManyLights, MayAllStandInOnePlace) {
  std::vector<Light> lights;
  for (int i = 0; i < 3000; ++i) lights.push_back(PointLight{{1, 2, 3}, white()});
  const LightSelector selector(lights, 1.0);
  for (const Vec3d p : {Vec3d(1, 2, 3), Vec3d(0, 0, 0)}) {
    EXPECT_NEAR(selector.probability({p}, 1234), 1.0 / 3000, 1e-6);
  }
}

TEST(ManyLights, TakeTheMemoryThatIsStated) {
  Random random(37);
  std::vector<Influence> influences;
  for (const Light& light : crowd(1000, random)) influences.push_back(influence(light));
  EXPECT_LE(LightTree(influences).bytes(), 136 * influences.size());
}

// The axes and angles of the cones are random; a direction within either must be within the union.
TEST(EmissionCones, AreHeldByTheirUnion) {
  Random random(41);
  for (int k = 0; k < 20000; ++k) {
    const EmissionCone a{random.direction(), pi * random.magnitude(-4, 0), 0.3};
    const Vec3d axis = k % 3 == 0   ? -a.axis
                       : k % 3 == 1 ? normalize(a.axis + 1e-7 * random.direction())
                                    : random.direction();
    const EmissionCone b{axis, pi * random.magnitude(-4, 0), 1.2};
    const EmissionCone both = united(a, b);
    EXPECT_EQ(both.spread, 1.2);
    for (const EmissionCone& part : {a, b}) {
      const Frame frame = Frame::from_normal(part.axis);
      const double phi = random.uniform(0, 2 * pi);
      const Vec3d rim =
          frame.to_world({std::sin(part.angle) * std::cos(phi),
                          std::sin(part.angle) * std::sin(phi), std::cos(part.angle)});
      const double off = std::atan2(length(cross(rim, both.axis)), dot(rim, both.axis));
      EXPECT_LE(off, both.angle + 1e-9) << k;
    }
  }
}

}  // namespace
}  // namespace lapidary::light
