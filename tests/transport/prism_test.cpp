#include <numeric>

#include <gtest/gtest.h>

#include "transport/probe.h"
#include "transport/vertex.h"

namespace lapidary::test {
namespace {

// A prism of apex angle A bends light least where its path is symmetric, by D with
// sin((A + D) / 2) = n sin(A / 2); light then comes in at (A + D) / 2 to the normal.
double least_deviation(double apex, double n) {
  return 2.0 * std::asin(n * std::sin(0.5 * apex)) - apex;
}

/// Light in the plane z = 0 that comes to `meets` on the left face of a prism, at `incidence` to
/// its normal. The apex edge is the z axis, the base faces -y.
geometry::Ray towards_left_face(double apex, double incidence, double meets = 0.4) {
  const Vec3d along{-std::sin(0.5 * apex), -std::cos(0.5 * apex), 0};
  const Vec3d inward{std::cos(0.5 * apex), -std::sin(0.5 * apex), 0};
  // From below, so that the two refractions bend it towards the base.
  const Vec3d direction = inward * std::cos(incidence) - along * std::sin(incidence);
  return ray(along * meets - direction * 3.0, direction);
}

/// The direction in which the hero wavelength leaves a scene of glass after two refractions, by
/// the path tracer's own steps.
Vec3d refracted_twice(const scene::Scene& scene, geometry::Ray r, const Wavelengths& wavelengths) {
  auto carried = bsdf::Carried::all;
  for (int surfaces = 0;; ++surfaces) {
    const geometry::Hit hit = scene.world().nearest(r);
    if (hit.kind == geometry::SurfaceKind::none) {
      EXPECT_EQ(surfaces, 2);
      return r.direction;
    }
    const geometry::Surface surface = scene.world().surface(r, hit);
    // Outside of the prism there is nothing.
    const bool enters = dot(surface.geometric_normal, r.direction) < 0.0;
    const std::uint32_t inside = hit.kind == geometry::SurfaceKind::triangle
                                     ? scene.mesh_filling(hit.index).medium
                                     : scene.region_filling(hit.region_before).medium +
                                           scene.region_filling(hit.region_after).medium;
    const medium::Medium &before = scene.medium(enters ? 0 : inside),
                         &after = scene.medium(enters ? inside : 0);
    const transport::Vertex vertex = transport::make_vertex(
        {scene.material(scene.slot(hit)), surface, {}, r.direction, before, after}, wavelengths,
        carried);
    const auto sample =
        bsdf::sample(vertex.bsdf, vertex.wo, 0.999, {0.5, 0.5}, bsdf::Mode::radiance);
    EXPECT_TRUE(sample && sample->side == bsdf::Side::transmitted);
    if (!sample) return {};
    carried = sample->carried;
    r = geometry::World::leave(surface, vertex.frame.to_world(sample->wi));
  }
}

double angle_between(Vec3d a, Vec3d b) {
  return std::atan2(length(cross(a, b)), dot(a, b));
}

/// Wavelengths whose heroes are blue, green and red.
const std::vector<Wavelengths> heroes{Wavelengths::sample(0.15), Wavelengths::sample(0.5),
                                      Wavelengths::sample(0.85)};

TEST(Prism, BendsEachWavelengthByItsIndex) {
  const double apex = radians(60);
  std::vector<double> bent;
  for (const char* name : {"N-BK7", "N-SF11"}) {
    const scene::Scene scene = TinyScene().add_mesh(prism_mesh(apex), glass(name)).build();
    for (const Wavelengths& wavelengths : heroes) {
      const double n = find_glass(name)->at(wavelengths.lambda(0));
      const double least = least_deviation(apex, n);
      const auto deviation = [&](double incidence) {
        const geometry::Ray in = towards_left_face(apex, incidence);
        return angle_between(in.direction, refracted_twice(scene, in, wavelengths));
      };
      const double symmetric = 0.5 * (apex + least);
      // The prism's corners are floats.
      EXPECT_NEAR(deviation(symmetric), least, 5e-7) << name << ' ' << wavelengths.lambda(0);
      EXPECT_GT(deviation(symmetric + radians(2)), least + 1e-4);
      EXPECT_GT(deviation(symmetric - radians(2)), least + 1e-4);
      bent.push_back(least);
    }
  }
  EXPECT_GT(heroes[1].lambda(0), heroes[0].lambda(0) + 30);
  EXPECT_GT(heroes[2].lambda(0), heroes[1].lambda(0) + 30);
  EXPECT_TRUE(bent[0] > bent[1] && bent[1] > bent[2]);
  EXPECT_GT(bent[3] - bent[5], 2.0 * (bent[0] - bent[2]));  // flint against crown
}

// The same by a corner of a box: exact in double, and of an index that lets light through 90
// degrees.
TEST(Prism, OfASolidBendsToRounding) {
  const double apex = radians(90);
  const double n = 1.333;
  // The box's corner edge lies on the z axis, its diagonal along -y.
  const Transform place = Transform::rotation({0, 0, 1}, radians(-135));
  const scene::Scene scene =
      TinyScene().add(geometry::Box{{0, 0, -1}, {1, 1, 1}}, glass(n), place).build();
  const double least = least_deviation(apex, n);
  const geometry::Ray in = towards_left_face(apex, 0.5 * (apex + least));
  EXPECT_NEAR(angle_between(in.direction, refracted_twice(scene, in, heroes[0])), least, 1e-14);
}

// End to end: the path tracer's rays find a lamp of a ten-thousandth of a radian where the formula
// says, for the hero's index, and none beside it.
TEST(Prism, ShowsALampWhereItsLightGoes) {
  const double apex = radians(60);
  const double far = 50.0;
  for (const Wavelengths& wavelengths : heroes) {
    const double n = find_glass("N-SF11")->at(wavelengths.lambda(0));
    const double least = least_deviation(apex, n);
    const geometry::Ray in = towards_left_face(apex, 0.5 * (apex + least));
    // By symmetry the way out is the way in, mirrored in x.
    const Vec3d out{in.direction.x, -in.direction.y, 0};
    const Vec3d leaves_at{0.4 * std::sin(0.5 * apex), -0.4 * std::cos(0.5 * apex), 0};
    const auto seen = [&](double aside) {
      TinyScene tiny;
      const Vec3d across = cross(out, {0, 0, 1});
      const Vec3d place = leaves_at + (out + across * aside) * far;
      tiny.add_mesh(prism_mesh(apex), glass("N-SF11"));
      tiny.add(geometry::Sphere{place, 0.5e-4 * far}, lamp(1.0));
      const scene::Scene scene = tiny.build();
      const transport::PathTracer tracer(scene, {.max_depth = 2});
      transport::Counters counters;
      double sum = 0.0;
      for (std::uint32_t i = 0; i < 64; ++i) {
        const PixelSampler points(1, 2, 3, i);
        transport::FirstSurface first;
        sum += tracer.radiance(in, {wavelengths, points, counters, {}}, first).average();
      }
      return sum / 64;
    };
    EXPECT_NEAR(seen(0.0), 0.75, 0.25);  // less by Fresnel's reflections
    EXPECT_EQ(seen(1.1e-4), 0.0);
    EXPECT_EQ(seen(-1.1e-4), 0.0);
  }
}

}  // namespace
}  // namespace lapidary::test
