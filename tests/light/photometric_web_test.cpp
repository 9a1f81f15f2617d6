#include "light/photometric_web.h"

#include <gtest/gtest.h>

#include "light/ies_file.h"
#include "light/lights.h"
#include "support/chi_squared.h"
#include "support/statistics.h"

namespace lapidary::light {
namespace {

using lapidary::test::Random;
using lapidary::test::RunningMean;
using Table = PhotometricWeb::Table;

/// The direction of a vertical and a horizontal angle in degrees.
Vec3d towards(double vertical, double horizontal) {
  const double v = radians(vertical), h = radians(horizontal);
  return {std::sin(v) * std::cos(h), -std::sin(v) * std::sin(h), std::cos(v)};
}

/// Uneven angles, zeros among the values.
Table table_of(std::vector<double> vertical, std::vector<double> horizontal, std::uint64_t seed) {
  Random random(seed);
  Table table{std::move(vertical), std::move(horizontal), {}};
  for (std::size_t i = 0; i < table.vertical.size() * table.horizontal.size(); ++i) {
    const double x = random.uniform() < 0.3 ? 0.0 : random.magnitude(0, 3);
    table.candela.push_back(static_cast<float>(x));
  }
  return table;
}

Table of_type(PhotometricWeb::Type type, Table table) {
  table.type = type;
  return table;
}

std::vector<Table> tables() {
  using Type = PhotometricWeb::Type;
  return {table_of({0, 10, 45, 90}, {0}, 1),
          table_of({0, 30, 50, 90, 180}, {0, 45, 90}, 2),
          table_of({90, 120, 180}, {0, 22.5, 120, 180}, 3),
          table_of({0, 60, 120, 180}, {90, 135, 225, 270}, 4),
          table_of({0, 5, 80, 90}, {0, 70, 200, 310, 360}, 5),
          of_type(Type::a, table_of({-40, 10, 20, 90}, {0, 30, 50, 90}, 10)),
          of_type(Type::b, table_of({-90, 10, 20, 70}, {-80, 30, 50}, 11)),
          of_type(Type::b, table_of({0, 20, 70}, {0, 30, 90}, 12))};
}

TEST(PhotometricWeb, IsTheTableAtItsAnglesAndLinearBetween) {
  const PhotometricWeb web({{0, 90, 180}, {0, 90}, {10, 20, 30, 10, 40, 30}});
  EXPECT_NEAR(web.intensity(towards(0, 0)), 10, 1e-9);
  EXPECT_NEAR(web.intensity(towards(90, 0)), 20, 1e-9);
  EXPECT_NEAR(web.intensity(towards(90, 90)), 40, 1e-9);
  EXPECT_NEAR(web.intensity(towards(90, 45)), 30, 1e-9);
  EXPECT_NEAR(web.intensity(towards(45, 0)), 15, 1e-9);
  EXPECT_NEAR(web.intensity(towards(135, 90)), 35, 1e-9);
}

TEST(PhotometricWeb, FollowsTheSymmetriesOfTheStandard) {
  Random random(7);
  const std::vector<Table> all = tables();
  for (int k = 0; k < 300; ++k) {
    const double v = random.uniform(0, 180), h = random.uniform(0, 360);
    const auto same = [&](const Table& table, double like) {
      const PhotometricWeb web(table);
      EXPECT_NEAR(web.intensity(towards(v, h)), web.intensity(towards(v, like)), 1e-6);
    };
    same(all[0], random.uniform(0, 360));
    same(all[1], 180 - h);
    same(all[1], -h);
    same(all[2], -h);
    same(all[3], 180 - h);
  }
}

TEST(PhotometricWeb, IsDarkBeyondItsVerticalAngles) {
  const PhotometricWeb down({{0, 90}, {0}, {5, 5}}), up({{90, 180}, {0}, {5, 5}});
  EXPECT_EQ(down.intensity(towards(91, 10)), 0.0);
  EXPECT_NEAR(down.intensity(towards(89, 10)), 5, 1e-9);
  EXPECT_EQ(up.intensity(towards(89, 10)), 0.0);
  EXPECT_NEAR(down.flux(), 5 * 2 * pi, 1e-9);
  EXPECT_NEAR(PhotometricWeb({{0, 90, 180}, {0}, {7, 7, 7}}).flux(), 7 * 4 * pi, 1e-9);
  EXPECT_NEAR(down.least_cosine(), 0.0, 1e-12);
  EXPECT_NEAR(PhotometricWeb({{0, 30, 60, 90}, {0}, {1, 1, 0, 0}}).least_cosine(), 0.5, 1e-12);
}

// Against the mean over uniform directions: 5 standard errors, 6e-7 false alarms for each of
// sixteen.
TEST(PhotometricWeb, HasTheFluxOfItsIntensity) {
  Random random(13);
  for (const Table& table : tables()) {
    const PhotometricWeb web(table);
    RunningMean uniform, sampled;
    for (int i = 0; i < 50000; ++i) {
      uniform.add(4 * pi * web.intensity(random.direction()));
      const auto [direction, pdf] = web.sample(random.uniform2());
      EXPECT_NEAR(web.pdf(direction), pdf, 1e-9 * pdf);
      sampled.add(web.intensity(direction) / pdf);
    }
    const auto by_all = lapidary::test::z_test(uniform, web.flux(), 5);
    EXPECT_TRUE(by_all.accepted) << by_all.message;
    const auto by_samples = lapidary::test::z_test(sampled, web.flux(), 5);
    EXPECT_TRUE(by_samples.accepted) << by_samples.message;
  }
}

TEST(PhotometricWeb, OfANarrowBeamIsSampledWhereItShines) {
  Table beam{{}, {0}, {}};
  for (int degree = 0; degree <= 90; ++degree) {
    beam.vertical.push_back(degree);
    beam.candela.push_back(static_cast<float>(1e4 * std::exp(-0.05 * degree * degree)));
  }
  const PhotometricWeb web(beam);
  Random random(17);
  RunningMean sampled;
  for (int i = 0; i < 20000; ++i) {
    const auto [direction, pdf] = web.sample(random.uniform2());
    sampled.add(web.intensity(direction) / pdf);
  }
  EXPECT_LT(std::sqrt(sampled.variance()), 0.2 * web.flux());
}

// The angles fall on the edges of the grid's cells, where the density jumps. Four tests that share
// a false-alarm rate of 1e-6.
TEST(PhotometricWeb, IsSampledWithItsDensity) {
  const auto at = [](double cosine) { return degrees(std::acos(cosine)); };
  for (const Table& table : {table_of({0, at(0.75), at(0.25), 90}, {0}, 6),
                             table_of({0, at(0.5), at(-0.125), 180}, {0, 22.5, 90}, 7),
                             table_of({90, at(-0.625), 180}, {0, 45, 112.5, 180}, 8),
                             table_of({0, at(0.875), 90, 180}, {90, 135, 225, 270}, 9)}) {
    const PhotometricWeb web(table);
    const auto result = lapidary::test::test_directions(
        [&](Random& random) -> std::optional<Vec3d> {
          return web.sample(random.uniform2()).direction;
        },
        [&](Vec3d direction) { return web.pdf(direction); },
        {.samples = 50000, .significance = 1e-6, .tests = 4, .max_depth = 2},
        lapidary::test::sphere_grid(16, 16));
    EXPECT_TRUE(result.accepted) << result.message;
  }
}

TEST(ProfileLight, ShinesAsItIsTurned) {
  const auto web = std::make_shared<const PhotometricWeb>(
      Table{{0, 90}, {0, 90, 180, 270, 360}, {8, 1, 8, 2, 8, 3, 8, 4, 8, 1}});
  const Light down = ProfileLight({{0, 0, 2}}, web, test::white());
  const auto irradiance = [](const Light& light, Vec3d p) {
    const auto s = sample_illumination(light, p, {}, test::wavelengths());
    return s ? s->L[0] : 0.0f;
  };
  EXPECT_NEAR(irradiance(down, {0, 0, 0}), 8.0 / 4.0, 1e-6);
  EXPECT_NEAR(irradiance(down, {0, 1, 2}), 1.0, 1e-5) << "angle 0 is towards +y";
  EXPECT_NEAR(irradiance(down, {-1, 0, 2}), 2.0, 1e-5) << "counter-clockwise from above";
  EXPECT_NEAR(irradiance(down, {0, -1, 2}), 3.0, 1e-5);
  EXPECT_EQ(irradiance(down, {0, 1, 3}), 0.0f);
  const Light sideways = ProfileLight({{0, 0, 2}, {3, 0, 0}, {0, 0, 5}}, web, test::white());
  EXPECT_NEAR(irradiance(sideways, {2, 0, 2}), 8.0 / 4.0, 1e-6);
  EXPECT_NEAR(irradiance(sideways, {0, 0, 3}), 1.0, 1e-5);
  EXPECT_TRUE(is_delta(down));
  // White is 1 per nm over 470 nm.
  EXPECT_NEAR(power(down, 1.0), 470 * web->flux(), 1e-6 * 470 * web->flux());
}

}  // namespace
}  // namespace lapidary::light
