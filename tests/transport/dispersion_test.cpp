#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.h"
#include "transport/photon_tracer.h"
#include "transport/probe.h"

// Where the wavelengths of a photon may be taken to fall together.
namespace lapidary::transport {
namespace {

using namespace test;

TEST(CoarseLength, IsAtMostAPercentTooLarge) {
  EXPECT_EQ(CoarseLength().value(), 0.0f);
  EXPECT_EQ(CoarseLength(0.0f).value(), 0.0f);
  EXPECT_EQ(CoarseLength(std::numeric_limits<float>::infinity()).value(),
            std::numeric_limits<float>::infinity());
  Random random(1);
  for (int i = 0; i < 10'000; ++i) {
    const auto length = static_cast<float>(std::pow(10.0, random.uniform(-30.0, 30.0)));
    const float kept = CoarseLength(length).value();
    EXPECT_GE(kept, length);
    EXPECT_LE(kept, 1.01f * length);
  }
}

// Photons of all four heroes bring all light together, however much of it each brings by itself.
TEST(LightWithin, OfAllHeroesIsTheWholeLight) {
  const SampledSpectrum power(1.0f, 2.0f, 0.5f, 3.0f);
  for (const float dispersion : {0.0f, 1e-9f, 0.1f, 0.3f, 0.49f, 0.6f, 100.0f}) {
    SampledSpectrum sum;
    for (std::size_t hero = 0; hero < 4; ++hero) {
      sum += 0.25f * light_within(1.0, power, dispersion, hero);
    }
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(sum[i], power[i], 1e-6);
  }
  EXPECT_EQ(light_within(1.0, power, 100.0f, 1)[1], 8.0f);
  EXPECT_EQ(light_within(1.0, power, 100.0f, 1)[2], 0.0f);
  EXPECT_EQ(light_within(0.0, power, 1e-20f, 2)[3], 0.0f);
  EXPECT_EQ(light_within(0.0, power, 0.0f, 2)[3], 3.0f);
}

/// Where each hero of a photon of this number falls at first, after two refractions.
struct Fall {
  Vec3d p;
  double dispersion = 0;
  SampledSpectrum power, power_here;
};
using Falls = std::array<std::optional<Fall>, 4>;

/// A body of glass in a black room, beside a small lamp.
class Stage {
 public:
  explicit Stage(TinyScene body)
      : scene_(body.add_outside(geometry::Box{{-6, -6, -6}, {6, 6, 6}}, matte(0.0))
                   .add(geometry::Sphere{{-3, -1.5, 0.1}, 0.05}, lamp(5.0))
                   .build()) {}

  Falls falls(std::uint32_t number) const {
    Counters counters;
    Falls falls;
    for (std::size_t hero = 0; hero < 4; ++hero) {
      tracer_.trace(
          {1, 0, number}, heroes_[hero],
          [&](const PhotonTracer::Arrival& at) {
            if (at.walk.depth() != 2 || falls[hero]) return;
            falls[hero] = {at.walk.surface().p, static_cast<double>(at.dispersion), at.power,
                           at.power_here()};
          },
          counters);
    }
    return falls;
  }

 private:
  scene::Scene scene_;
  PhotonEmitter emitter_{scene_};
  PhotonTracer tracer_{scene_, emitter_, 6};
  Heroes heroes_ = every_hero(Wavelengths::sample(0.3));
};

TinyScene ball(description::MaterialPtr worn) {
  return TinyScene().add(geometry::Sphere{{}, 1.0}, std::move(worn));
}

/// Quantiles of what photons say of their dispersion over what it is.
struct Ratios {
  double low = 0, median = 0, high = 0;  ///< 5 %, 50 %, 95 %
};

Ratios ratios_of(TinyScene body) {
  const Stage stage(std::move(body));
  std::vector<double> ratios;
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    const Falls falls = stage.falls(i);
    if (!std::ranges::all_of(falls, [](const auto& fall) { return fall.has_value(); })) continue;
    double apart = 0.0;
    for (const auto& a : falls) {
      for (const auto& b : falls) apart = std::max(apart, length(a->p - b->p));
    }
    for (const auto& fall : falls) {
      // Where another wavelength would have been reflected the hero goes on alone.
      if (fall->power.min() > 0.0f) ratios.push_back(fall->dispersion / apart);
    }
  }
  EXPECT_GT(ratios.size(), 4000u);
  std::ranges::sort(ratios);
  const auto quantile = [&](double q) {
    return ratios[static_cast<std::size_t>(q * static_cast<double>(ratios.size()))];
  };
  return {quantile(0.05), quantile(0.5), quantile(0.95)};
}

// Two surfaces that part colours the same way: both angles count, nothing magnifies them. The
// screen is met at all angles, which stretches what falls there.
TEST(Dispersion, BehindAPrismIsWhatItIs) {
  const Ratios ratios = ratios_of(TinyScene().add_mesh(prism_mesh(radians(40)), glass("N-SF11")));
  EXPECT_GT(ratios.low, 0.85);
  EXPECT_GT(ratios.median, 0.95);
  EXPECT_LT(ratios.median, 1.05);
  EXPECT_LT(ratios.high, 1.2);
}

// The second surface of a ball brings together again what its first has parted.
TEST(Dispersion, BehindABallIsRightToASmallFactor) {
  const Ratios ratios = ratios_of(ball(glass("N-SF11")));
  EXPECT_GT(ratios.low, 1.0);
  EXPECT_LT(ratios.high, 5.0);
}

bool is_little_dispersed(const std::optional<Fall>& fall) {
  return fall && fall->power.min() > 0.0f && fall->dispersion < 0.4;
}

// Each wavelength keeps its own transmittance, although all go one way: what heroes say they bring
// by themselves agrees with what others say of them.
TEST(Dispersion, LeavesEachWavelengthItsPower) {
  const Stage stage(ball(glass("N-SF11")));
  SampledSpectrum together, alone;
  for (std::uint32_t i = 0; i < 20'000; ++i) {
    const Falls falls = stage.falls(i);
    // Those of steep ways into the ball, not of its rim, where wavelengths differ more.
    if (!std::ranges::all_of(falls, is_little_dispersed)) continue;
    for (const auto& fall : falls) {
      together += fall->power;
      alone += fall->power_here;
    }
  }
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(together[i] / alone[i], 1.0, 0.002) << alone[i];
}

// Rough glass parts them for good.
TEST(Dispersion, BehindRoughGlassIsTheHerosAlone) {
  const Stage stage(ball(material(description::Glass{*find_glass("N-SF11"), 0.2})));
  int found = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Falls falls = stage.falls(i);
    for (std::size_t hero = 0; hero < 4; ++hero) {
      if (!falls[hero]) continue;
      ++found;
      for (std::size_t j = 0; j < 4; ++j) ASSERT_EQ(falls[hero]->power[j] > 0.0f, j == hero);
    }
  }
  EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace lapidary::transport
