#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "scene/tiny_scene.h"
#include "transport/photon_tracer.h"

// Where photons come together: focal spots and cusps of which optics says where they are.
namespace lapidary::transport {
namespace {

using namespace test;

/// A photon that was focused, where it fell.
struct Fallen {
  Vec3d p;
  double power = 0;
};

std::vector<Fallen> fallen(const TinyScene& tiny, std::uint32_t photons) {
  const scene::Scene scene = tiny.build();
  const PhotonEmitter emitter(scene);
  const PhotonTracer tracer(scene, emitter, 6);
  const Wavelengths wavelengths = Wavelengths::sample(0.5);
  Counters counters;
  std::vector<Fallen> found;
  for (std::uint32_t i = 0; i < photons; ++i) {
    tracer.trace(
        {1, 0, i}, wavelengths,
        [&](const PhotonTracer::Arrival& at) {
          found.push_back({at.walk.surface().p, static_cast<double>(at.power.average())});
        },
        counters);
  }
  return found;
}

std::shared_ptr<const description::Object> solid(const geometry::Solid& shape) {
  description::Object object;
  object.content = shape;
  return std::make_shared<const description::Object>(std::move(object));
}

void add_combined(TinyScene& tiny, description::SetOperation operation,
                  const std::array<geometry::Solid, 2>& shapes,
                  const description::MaterialPtr& worn) {
  const auto both = description::combined(operation, solid(shapes[0]), solid(shapes[1]), {});
  tiny.description.objects.push_back(description::with_material(*both, worn));
}

/// Two balls of radius R whose intersection is a lens of aperture radius h about the origin.
struct Lens {
  double R = 4.0, h = 0.4, n = 1.5;

  double sag() const { return R - std::sqrt(R * R - h * h); }
  /// From its back vertex, by the lensmaker's formula of thick lenses (Born & Wolf, 4.4).
  double back_focus() const {
    const double d = 2.0 * sag();
    const double f = 1.0 / ((n - 1) * (2.0 / R - (n - 1) * d / (n * R * R)));
    return f * (1.0 - (n - 1) * d / (n * R));
  }
  /// How much nearer the rays of the rim meet than those of the axis, in third order: of a thin
  /// lens that is as strong on both sides, for light from far away (Jenkins & White, 9.5).
  double aberration() const {
    const double f = R / (2.0 * (n - 1));
    const double k = ((3 * n + 2) * (n - 1) + n * n * n / (n - 1)) / (8.0 * n * (n - 1));
    return k * h * h / f;
  }
  /// Root of the mean square distance from the axis, of light that falls on a screen so far behind.
  double spot(double behind) const {
    TinyScene tiny;
    const double offset = R - sag();
    add_combined(tiny, description::SetOperation::intersect,
                 {geometry::Sphere{{0, 0, offset}, R}, geometry::Sphere{{0, 0, -offset}, R}},
                 glass(n));
    tiny.add(geometry::Disk{{0, 0, -sag() - behind}, {0, 0, 1}, 0.2}, matte(0.0));
    tiny.light(
        description::DistantLight{{0, 0, -1}, 0, {description::Quantity::irradiance, grey(1)}});
    double sum = 0.0, squares = 0.0;
    for (const Fallen& photon : fallen(tiny, 20'000)) {
      sum += photon.power;
      squares += photon.power * (photon.p.x * photon.p.x + photon.p.y * photon.p.y);
    }
    return std::sqrt(squares / sum);
  }
};

// The least spot of an evenly lit aperture lies two thirds of the aberration before the focus of
// rays near the axis, where the mean square of a r - b r^3 is least, and has a radius of a sixth of
// the rim's aberration across. What third order and a thin lens leave out of it are shares of
// h^2/R^2 and of thickness over focus, of one per cent each; a step of the search is a tenth of it.
TEST(Focus, OfALensIsWhereTheLensmakersFormulaSays) {
  const Lens lens;
  const double expected = lens.back_focus() - lens.aberration() * 2.0 / 3.0;
  const double step = 0.1 * lens.aberration();
  double best = 0.0, least = infinity;
  for (int i = -12; i <= 12; ++i) {
    const double behind = expected + i * step;
    const double spot = lens.spot(behind);
    if (spot < least) least = spot, best = behind;
  }
  EXPECT_NEAR(best, expected, 2.0 * step);
  EXPECT_NEAR(least, lens.aberration() * lens.h / lens.back_focus() / 6.0, 0.2 * least);
}

/// Inside of half a cylinder of radius 1 about z, a mirror where x > 0, over a black floor.
TinyScene half_ring() {
  TinyScene tiny;
  add_combined(tiny, description::SetOperation::subtract,
               {geometry::Box{{0, -1.5, 0.001}, {1.5, 1.5, 3}},
                geometry::Cylinder{{0, 0, -1}, {0, 0, 4}, 1.0}},
               metal(1.0));
  tiny.add(geometry::Rectangle{{-3, -3, 0}, {6, 0, 0}, {0, 6, 0}}, matte(0.0));
  return tiny;
}

/// Where along the axis most light falls, near it, in bins.
double brightest_on_axis(const TinyScene& tiny, double bin) {
  constexpr double aside = 0.004;
  std::vector<double> bins(static_cast<std::size_t>(std::ceil(1.0 / bin)));
  for (const Fallen& photon : fallen(tiny, 600'000)) {
    if (std::abs(photon.p.y) > aside || photon.p.x < 0.0 || photon.p.x >= 1.0) continue;
    bins[static_cast<std::size_t>(photon.p.x / bin)] += photon.power;
  }
  const auto most = std::max_element(bins.begin(), bins.end());
  return (static_cast<double>(most - bins.begin()) + 0.5) * bin;
}

// Of light that comes along x, by s + 1/s' = 2/R: a nephroid, seen from above, whose cusp is half a
// radius from the middle. However flat light comes in, from above it is the same.
TEST(Focus, OfARingAndTheSunIsANephroidsCusp) {
  TinyScene tiny = half_ring();
  tiny.light(
      description::DistantLight{{1, 0, -0.8}, 0, {description::Quantity::irradiance, grey(1)}});
  constexpr double bin = 0.02;
  EXPECT_NEAR(brightest_on_axis(tiny, bin), 0.5, bin);
}

// And of light on the ring, opposite: a cardioid, whose cusp is a third of the radius away.
TEST(Focus, OfARingAndALampOnItIsACardioidsCusp) {
  TinyScene tiny = half_ring();
  tiny.light(description::PointLight{{-1, 0, 2.0}, {description::Quantity::intensity, grey(1)}});
  constexpr double bin = 0.02;
  EXPECT_NEAR(brightest_on_axis(tiny, bin), 1.0 / 3.0, bin);
}

}  // namespace
}  // namespace lapidary::transport
