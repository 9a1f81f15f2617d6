#include "transport/photon_map.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace lapidary {
namespace {

using transport::Photon;
using transport::PhotonMap;

/// Photons spread over a flat square, in clusters, and at one and the same point.
std::vector<Photon> photons(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> u(-1.0f, 1.0f);
  std::vector<Photon> made(count);
  for (std::size_t i = 0; i < count; ++i) {
    // A few have flown off over a floor without end.
    const float size = i % 100 == 7 ? 1e7f : i % 3 == 0 ? 10.0f : i % 3 == 1 ? 0.01f : 0.0f;
    made[i].position = Vec3f(3.0f + size * u(random), size * u(random), 0.1f * size * u(random));
    made[i].power = SampledSpectrum(static_cast<float>(i));
  }
  return made;
}

std::vector<float> found(const PhotonMap& map, Vec3d p, double radius) {
  std::vector<float> names;
  map.for_each_near(p, radius,
                    [&](const Photon& photon, double) { names.push_back(photon.power[0]); });
  std::sort(names.begin(), names.end());
  return names;
}

// The oracle looks at all of them, in the arithmetic of the map.
std::vector<float> expected(const std::vector<Photon>& all, Vec3d origin, Vec3d p, double radius) {
  std::vector<float> names;
  const Vec3f at(p - origin);
  const auto r = static_cast<float>(radius);
  for (const Photon& photon : all) {
    if (length_squared(photon.position - at) < r * r) names.push_back(photon.power[0]);
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(PhotonMapTest, FindsEveryPhotonOnceAtAnyRadius) {
  const Vec3d origin(100, -50, 7);
  for (const PhotonMap::Radii radii :
       {PhotonMap::Radii{0.001, 4.0}, PhotonMap::Radii{0.3, 0.3}, PhotonMap::Radii{1e-9, 1e-7},
        PhotonMap::Radii{50.0, 80.0}}) {
    const std::vector<Photon> all = photons(3000, 5);
    const PhotonMap map(all, origin, radii);
    std::mt19937 random(9);
    std::uniform_real_distribution<double> u(0.0, 1.0);
    for (int i = 0; i < 300; ++i) {
      const double radius = radii.smallest * std::pow(radii.largest / radii.smallest, u(random));
      const Photon& near = all[static_cast<std::size_t>(u(random) * 3000.0)];
      const Vec3d p = origin + Vec3d(near.position) +
                      Vec3d(u(random) - 0.5, u(random) - 0.5, u(random) - 0.5) * (3.0 * radius);
      EXPECT_EQ(found(map, p, radius), expected(all, origin, p, radius)) << radius << " " << i;
    }
  }
}

TEST(PhotonMapTest, HasNothingWhereThereIsNothing) {
  const PhotonMap empty;
  EXPECT_TRUE(found(empty, {0, 0, 0}, 1.0).empty());
  const PhotonMap map(photons(100, 1), {}, {0.1, 0.1});
  EXPECT_TRUE(found(map, {1000, 0, 0}, 0.1).empty());
  EXPECT_TRUE(found(map, {-1e300, 0, 0}, 0.1).empty());
}

TEST(PhotonMapTest, OrderDependsOnThePhotonsAlone) {
  const PhotonMap a(photons(2000, 3), {}, {0.01, 1.0}), b(photons(2000, 3), {}, {0.01, 1.0});
  for (std::size_t i = 0; i < 2000; ++i) {
    EXPECT_EQ(a.photons()[i].power[0], b.photons()[i].power[0]);
  }
}

}  // namespace
}  // namespace lapidary
