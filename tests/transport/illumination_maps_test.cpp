#include "transport/illumination_maps.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/meshes.h"
#include "scene/solid_builders.h"
#include "support/random.h"
#include "transport/illumination_tracer.h"
#include "transport/probe.h"

namespace lapidary::test {
namespace {

using description::Quantity;
using geometry::SurfaceKind;
using transport::IlluminationMaps;
using transport::PhotonLight;
using transport::SurfaceSide;

IlluminationMaps::Settings settings(std::uint32_t photons, PhotonLight light,
                                    std::optional<double> radius = std::nullopt) {
  IlluminationMaps::Settings s;
  s.budget.photons = photons;
  s.budget.light = light;
  s.radius = radius;
  return s;
}

/// A scene with maps of it.
struct Mapped {
  scene::Scene scene;
  ThreadPool pool{1};
  IlluminationMaps maps;

  Mapped(const TinyScene& tiny, const IlluminationMaps::Settings& s)
      : scene(tiny.build()), maps(scene, s, pool) {}

  /// Where a ray first meets a surface, on the side it comes from. White light has equal parts.
  double irradiance(const geometry::Ray& seen) const {
    const geometry::Hit hit = scene.world().nearest(seen);
    EXPECT_NE(hit.kind, SurfaceKind::none);
    const geometry::Surface surface = scene.world().surface(seen, hit);
    const bool front = dot(surface.geometric_normal, seen.direction) < 0.0;
    const Rgb E = maps.irradiance(hit, surface, front ? SurfaceSide::front : SurfaceSide::back);
    return static_cast<double>((E.r + E.g + E.b) / 3.0f);
  }
};

Spectrum white(double strength) {
  const auto s = static_cast<float>(strength);
  return Spectrum::illuminant({s, s, s});
}

TinyScene& add_sky(TinyScene& tiny, double radiance) {
  return tiny.light(description::ConstantEnvironment{white(radiance)});
}

geometry::Solid round_prism() {
  std::vector<Vec2d> outline;
  for (int i = 0; i < 24; ++i) {
    outline.push_back({std::cos(2 * pi * i / 24), std::sin(2 * pi * i / 24)});
  }
  return geometry::make_prism({outline, {}}, 1.5, 0.7);
}

geometry::Solid bowl() {
  return geometry::make_lathe({{{0, 0}, {1, 0}, {1.1, 0.4}, {0.9, 0.9}, {0, 0.9}}, {}}, 360);
}

geometry::Solid ellipsoid() {
  const auto form = std::make_shared<geometry::QuadraticForm>();
  form->squares = {1.0, 2.0, 0.5};
  form->products = {0.2, 0.0, 0.1};
  return geometry::Quadric{form};
}

std::vector<geometry::Solid> convex_solids() {
  return {geometry::Sphere{},
          geometry::Box{{-1, -0.5, -0.7}, {1, 0.5, 0.7}},
          geometry::Cylinder{{0, 0, -1}, {0.2, 0.1, 1}, 0.8},
          geometry::Cone{{0, 0, -1}, {0, 0, 1}, 1.0, 0.3},
          geometry::Superellipsoid{{}, {1, 0.8, 0.6}, 0.5, 0.8},
          round_prism(),
          bowl(),
          ellipsoid()};
}

// The ground is what photons are divided by. Its area is that of the surface, in one way known from
// other code; here 1 % is left for texels that edges cross.
TEST(IlluminationGround, HasTheAreaOfTheSurface) {
  const auto area_of_ground = [](const scene::Scene& scene, const transport::SurfaceKey& key,
                                 transport::MappedSurface::Meshes mesh = nullptr) {
    const transport::MappedSurface surface(scene.world(), key, std::move(mesh));
    double sum = 0;
    for (std::uint32_t chart = 0; chart < surface.chart_count(); ++chart) {
      transport::TexelGrid grid = surface.ends(chart);
      grid.width = 90, grid.height = 70;
      auto range = surface.range(chart);
      if (!std::isfinite(range.min.x)) range = {{-1.6, -1.6}, {1.6, 1.6}};
      for (const double area : surface.ground(chart, grid, range).area) sum += area;
    }
    return sum;
  };
  const transport::SurfaceKey leaf{SurfaceKind::solid, 0, 0};
  const Transform turned =
      Transform::rotation({1, 2, 3}, 0.7) * Transform::scaling({1.5, 1.0, 1.2});
  for (const geometry::Solid& solid : convex_solids()) {
    SCOPED_TRACE(solid.index());
    const double own = geometry::area(solid);
    EXPECT_NEAR(area_of_ground(TinyScene().add(solid, matte(0.5)).build(), leaf), own, 0.01 * own);
    const double in_world = geometry::area(geometry::PlacedSolid(solid, turned));
    EXPECT_NEAR(area_of_ground(TinyScene().add(solid, matte(0.5), turned).build(), leaf), in_world,
                0.01 * in_world);
  }
  // Of a ball, what a box leaves of it: a cap of height 1/2.
  TinyScene cut;
  cut.add(geometry::Sphere{}, matte(0.5)).add(geometry::Box{{-2, -2, -2}, {2, 2, 0.5}}, matte(0.5));
  // Where both are there is nothing to see.
  const double cap = 2 * pi * 0.5;
  EXPECT_NEAR(area_of_ground(cut.build(), leaf), cap, 0.01 * cap);
  // Of a sheet, what is not buried in a block.
  TinyScene sheet;
  sheet.add(geometry::Rectangle{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, matte(0.5))
      .add(geometry::Box{{0, -2, -1}, {3, 3, 1}}, matte(0.5));
  EXPECT_NEAR(area_of_ground(sheet.build(), {SurfaceKind::sheet, 0, 0}), 2.0, 0.03);
  // Of meshes every triangle counts whole.
  const geometry::TriangleMesh torus = geometry::meshes::torus(30, 20);
  double area = 0;
  for (const auto& t : torus.triangles) {
    const Vec3d p = torus.position(t[0]);
    area += 0.5 * length(cross(torus.position(t[1]) - p, torus.position(t[2]) - p));
  }
  const auto charts = std::make_shared<const geometry::MeshCharts>(geometry::mesh_charts(torus));
  EXPECT_NEAR(area_of_ground(TinyScene().add_mesh(torus, matte(0.5)).build(),
                             {SurfaceKind::triangle, 0, 0}, charts),
              area, 1e-4 * area);
}

// Under a sky of the same radiance L from everywhere a convex body has the irradiance pi L on all
// of its surface: at seams, poles, edges and where charts meet. Some 2000 photons are within the
// radius, fewer at edges, and some 10000 fall on a chart: 3 and 1 % are standard errors of a point
// and of a chart's mean.
TEST(IlluminationMaps, OfAConvexBodyUnderAnEvenSkyAreConstant) {
  const double L = 0.7;
  Random random(51);
  std::vector<TinyScene> scenes;
  for (const geometry::Solid& solid : convex_solids())
    scenes.push_back(TinyScene().add(solid, matte(0.5)));
  scenes.push_back(TinyScene().add_mesh(geometry::meshes::cube(), matte(0.5)));
  for (TinyScene& tiny : scenes) {
    SCOPED_TRACE(&tiny - scenes.data());
    add_sky(tiny, L);
    const Mapped mapped(tiny, settings(120000, PhotonLight::all, 0.45));
    RunningMean mean;
    double worst = 0;
    for (int i = 0; i < 400; ++i) {
      const Vec3d d = random.direction();
      const double E = mapped.irradiance(ray_to(d * 5.0, d * 0.05));
      mean.add(E / (pi * L));
      worst = std::max(worst, std::abs(E / (pi * L) - 1.0));
    }
    EXPECT_NEAR(mean.mean(), 1.0, 0.03);
    EXPECT_LT(worst, 0.3);
  }
}

// The same of half a ball, which stands in two places and is cut by a plane without an end; each
// hides 1 % of the sky from the other.
TEST(IlluminationMaps, OfCutLeavesInSeveralPlacesAreConstant) {
  const double L = 0.7;
  TinyScene tiny;
  const auto half = with_material(
      *intersect(ball(), solid(geometry::HalfSpace{{0, 0, 0.1}, {0.2, 0, 1}})), matte(0.5));
  tiny.description.objects = {half, at(8, half)};
  add_sky(tiny, L);
  const Mapped mapped(tiny, settings(1000000, PhotonLight::all, 0.5));
  EXPECT_EQ(mapped.maps.surfaces().size(), 4u);
  Random random(54);
  for (const double x : {0.0, 8.0}) {
    RunningMean flat, round;
    for (int i = 0; i < 300; ++i) {
      const Vec3d d = random.direction(), p{x, 0, -0.2};
      const double E = mapped.irradiance(ray_to(p + d * 3.0, p));
      // The cut is seen from above.
      (d.z > 0.6 ? flat : round).add(E / (pi * L));
      EXPECT_NEAR(E / (pi * L), 1.0, 0.35);
    }
    EXPECT_NEAR(flat.mean(), 0.99, 0.04);
    EXPECT_NEAR(round.mean(), 0.99, 0.04);
  }
}

// A plane under the sky has all of its light as far as it has a map, and is black beyond.
TEST(IlluminationMaps, OfAPlaneAreRightAsFarAsTheyReach) {
  const double L = 0.7;
  TinyScene tiny;
  tiny.add(geometry::HalfSpace{}, matte(0.0));
  tiny.add(geometry::Rectangle{{-2, -2, -1}, {4, 0, 0}, {0, 4, 0}}, matte(0.0));
  add_sky(tiny, L);
  // The ball about the rectangle has a radius of 2.83, twice that at the height of the plane 5.57.
  const Mapped mapped(tiny, settings(300000, PhotonLight::all, 1.0));
  RunningMean inner, outer;
  for (int i = 0; i < 60; ++i) {
    const double phi = 2 * pi * i / 60;
    const auto at = [&](double r) {
      return mapped.irradiance(ray({r * std::cos(phi), r * std::sin(phi), 1}, {0, 0, -1}));
    };
    inner.add(at(1.0) / (pi * L));
    outer.add(at(5.0) / (pi * L));
    EXPECT_EQ(at(9.0), 0.0);
  }
  EXPECT_NEAR(inner.mean(), 1.0, 0.04);
  EXPECT_NEAR(outer.mean(), 1.0, 0.08);
}

// A lamp right above a cube lights its top and nothing else, up to the very edge.
TEST(IlluminationMaps, DoNotBleedFromChartToChart) {
  for (const bool is_mesh : {true, false}) {
    TinyScene tiny;
    if (is_mesh) tiny.add_mesh(geometry::meshes::cube(), matte(0.0));
    if (!is_mesh) tiny.add(geometry::Box{{-1, -1, -1}, {1, 1, 1}}, matte(0.0));
    tiny.light(description::PointLight{{0, 0, 2}, {Quantity::intensity, white(1.0)}});
    const Mapped mapped(tiny, settings(20000, PhotonLight::all, 0.5));
    const double middle = mapped.irradiance(ray({0, 0, 2}, {0, 0, -1}));
    EXPECT_GT(middle, 0.5);
    EXPECT_GT(mapped.irradiance(ray({0.99, 0, 2}, {0, 0, -1})), 0.2);
    for (const double z : {0.999, 0.9, 0.0, -0.999}) {
      EXPECT_EQ(mapped.irradiance(ray({3, 0.2, z}, {-1, 0, 0})), 0.0);
    }
  }
}

TEST(IlluminationMaps, UnderALampAreItsIrradiance) {
  const double intensity = 3.0;
  TinyScene tiny;
  tiny.add(geometry::Rectangle{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}}, matte(0.5));
  tiny.light(description::PointLight{{0, 0, 1}, {Quantity::intensity, white(intensity)}});
  const Mapped mapped(tiny, settings(400000, PhotonLight::all, 0.15));
  for (const Vec3d p : {Vec3d{0, 0, 0}, Vec3d{0.5, 0.5, 0}, Vec3d{1.2, -0.3, 0}}) {
    const double d2 = length_squared(p - Vec3d{0, 0, 1});
    const double expected = intensity / (d2 * std::sqrt(d2));
    EXPECT_NEAR(mapped.irradiance(ray_to(p + Vec3d{0.1, 0.1, 0.5}, p)), expected, 0.08 * expected);
  }
  // Nothing of it is indirect.
  const Mapped indirect(tiny, settings(1000, PhotonLight::indirect));
  EXPECT_EQ(indirect.maps.state(), IlluminationMaps::State::nothing_arrives);
}

// The integrating sphere of interreflection_test.cpp: beside its direct light f L pi the wall gets
// (1 - f) pi times its own radiance.
TEST(IlluminationMaps, InAnIntegratingSphereAreTheGeometricSeries) {
  const double albedo = 0.7, radius = 0.5, L = 4.0, f = radius * radius, q = albedo * (1.0 - f);
  TinyScene tiny;
  description::Emissive emissive;
  emissive.emission = {Quantity::radiance, white(L)};
  tiny.add_outside(geometry::Sphere{}, matte(albedo));
  tiny.add(geometry::Sphere{{}, radius}, material(emissive));
  for (const int depth : {2, 3, 40}) {
    auto how = settings(100000, PhotonLight::indirect, 0.4);
    how.budget.max_depth = depth;
    const Mapped mapped(tiny, how);
    // Light that was scattered once to depth - 1 times.
    const double wall = albedo * f * L * (1.0 - std::pow(q, depth - 1)) / (1.0 - q);
    const double expected = pi * (1.0 - f) * wall;
    RunningMean mean;
    Random random(52);
    for (int i = 0; i < 300; ++i) {
      const Vec3d d = random.direction();
      mean.add(mapped.irradiance(ray(d * 0.8, d)));
    }
    EXPECT_NEAR(mean.mean(), expected, 0.015 * expected) << depth;
  }
}

/// What falls in all on black surfaces that leave nothing out, in multiples of what is expected.
void expect_power(const TinyScene& tiny, double watts_per_nm, int max_depth = 1) {
  const scene::Scene scene = tiny.build();
  const transport::PhotonEmitter emitter(scene, transport::Aim::everywhere);
  ASSERT_TRUE(emitter.is_useful());
  const transport::PhotonTracer tracer(scene, emitter, max_depth, PhotonLight::all);
  const Wavelengths wavelengths = Wavelengths::sample(0.3);
  RunningMean mean;
  transport::Counters counters;
  for (std::uint32_t i = 0; i < 40000; ++i) {
    double sum = 0;
    const auto leave = [&](const transport::PhotonTracer::Arrival& at) {
      sum += static_cast<double>(at.power.average());
    };
    tracer.trace({7, 0, i}, wavelengths, leave, counters);
    mean.add(sum);
  }
  // A correct one is refused once in 370 times when it is first written, and never again.
  const ZTestResult result = z_test(mean, watts_per_nm, 3.0, 1e-5 * watts_per_nm);
  EXPECT_TRUE(result.accepted) << result.message;
  EXPECT_LT(mean.standard_error(), 0.03 * watts_per_nm);
}

TEST(IlluminationPhotons, BringThePowerOfEveryKindOfLight) {
  const auto black = matte(0.0);
  const auto room = [&] {
    TinyScene tiny;
    tiny.add_outside(geometry::Box{{-3, -3, -3}, {3, 3, 3}}, black);
    return tiny;
  };
  const double L = 2.0;
  {
    SCOPED_TRACE("sphere");
    expect_power(room().add(geometry::Sphere{{1, 0, 0}, 0.5}, lamp(L)), L * pi * 4 * pi * 0.25);
  }
  {
    SCOPED_TRACE("rectangle");
    expect_power(room().add(geometry::Rectangle{{-1, -1, 2.9}, {2, 0, 0}, {0, -2, 0}}, lamp(L)),
                 L * pi * 4);
  }
  {
    SCOPED_TRACE("disk");
    expect_power(room().add(geometry::Disk{{0, 0, 1}, {0, 0, -1}, 0.5}, lamp(L)),
                 L * pi * pi * 0.25);
  }
  {
    SCOPED_TRACE("box");
    expect_power(room().add(geometry::Box{}, lamp(L)), L * pi * 6);
  }
  {
    SCOPED_TRACE("mesh");
    expect_power(room().add_mesh(geometry::meshes::cube(), lamp(L)), L * pi * 24);
  }
  {
    SCOPED_TRACE("point");
    expect_power(room().light(description::PointLight{{}, {Quantity::intensity, grey(L)}}),
                 4 * pi * L);
  }
  {
    SCOPED_TRACE("spot");
    expect_power(room().light(description::SpotLight{
                     {}, {0, 0, -1}, 40, 0.0, {Quantity::intensity, grey(L)}}),
                 2 * pi * (1 - std::cos(radians(20))) * L);
  }
  {
    SCOPED_TRACE("distant");
    expect_power(
        TinyScene()
            .add(geometry::Sphere{}, black)
            .light(description::DistantLight{{0, 1, -1}, 0.5, {Quantity::irradiance, grey(L)}}),
        pi * L);
  }
  {
    SCOPED_TRACE("sky");
    expect_power(TinyScene().add(geometry::Sphere{}, black).sky(L), pi * L * 4 * pi);
  }
}

// Of two mirrors nothing is lost, however many photons are aimed at them.
TEST(IlluminationPhotons, BringTheSamePowerWhereTheyAreAimed) {
  TinyScene tiny;
  tiny.add_outside(geometry::Box{{-3, -3, -3}, {3, 3, 3}}, matte(0.0));
  tiny.add(geometry::Disk{{0, 0, 2.5}, {0, 0, -1}, 0.5}, lamp(2.0));
  tiny.add(geometry::Sphere{{1.5, 0, 0}, 0.3}, metal(1.0));
  tiny.add(geometry::Sphere{{-1, 0.5, -2}, 0.5}, metal(1.0));
  expect_power(tiny, 2.0 * pi * pi * 0.25, 30);
}

/// A room with a lamp, a red wall, a block, a glass ball and a mesh.
TinyScene small_room() {
  TinyScene tiny;
  const auto red = material(description::Matte{Spectrum::reflectance({0.6f, 0.1f, 0.1f})});
  tiny.add(geometry::Rectangle{{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, matte(0.7));
  tiny.add(geometry::Rectangle{{-1, 1, 0}, {2, 0, 0}, {0, 0, 2}}, matte(0.7));
  tiny.add(geometry::Rectangle{{-1, -1, 0}, {0, 2, 0}, {0, 0, 2}}, red);
  tiny.add(geometry::Box{{0.2, 0.2, 0}, {0.7, 0.7, 0.8}}, matte(0.6));
  tiny.add(geometry::Sphere{{-0.4, -0.2, 0.4}, 0.3}, glass(1.5));
  tiny.add_mesh(geometry::meshes::torus(24, 12), matte(0.5),
                Transform::translation({0.3, -0.4, 0.1}) * Transform::scaling({0.3, 0.3, 0.3}));
  tiny.add(geometry::Disk{{0, 0, 1.9}, {0, 0, -1}, 0.3}, lamp(10.0));
  return tiny;
}

TEST(IlluminationTracer, AgreesWithPathsWhereLightIsSmooth) {
  const TinyScene tiny = small_room();
  const Mapped mapped(tiny, settings(400000, PhotonLight::indirect));
  const transport::IlluminationTracer tracer(mapped.scene, mapped.maps, 16);
  transport::Counters counters;
  for (const Vec3d at :
       {Vec3d{0.8, -0.8, 0}, Vec3d{-0.5, 1, 1.2}, Vec3d{-1, 0.2, 1.0}, Vec3d{0.45, 0.2, 0.4}}) {
    const Vec3d eye{0.3, -3, 1.5};
    // The mean over a region, by either.
    RunningMean paths, maps;
    Random random(53);
    for (std::uint32_t i = 0; i < 4000; ++i) {
      const geometry::Ray seen = ray_to(eye, at + random.direction() * 0.08);
      const Wavelengths wavelengths = Wavelengths::sample(random.uniform());
      const PixelSampler points(5, i, 0, 0);
      const transport::SampleContext context{wavelengths, points, counters, {}};
      transport::FirstSurface first;
      const transport::PathTracer path(
          mapped.scene, {16, transport::Interreflection::full, transport::CausticMethod::paths});
      const auto green = [&](SampledSpectrum L) {
        return static_cast<double>(wavelengths.to_rgb(L).g);
      };
      paths.add(green(path.radiance(seen, context, first)));
      maps.add(green(tracer.radiance(seen, context, first)));
    }
    EXPECT_NEAR(
        maps.mean(), paths.mean(),
        0.03 * paths.mean() + 4.0 * std::hypot(paths.standard_error(), maps.standard_error()))
        << at.x << ' ' << at.y;
  }
}

TEST(IlluminationMaps, AreTheSameForAnyNumberOfThreads) {
  const scene::Scene scene = small_room().build();
  ThreadPool one(1), three(3);
  const auto how = settings(30000, PhotonLight::indirect);
  const IlluminationMaps a(scene, how, one), b(scene, how, three);
  ASSERT_EQ(a.entries().size(), b.entries().size());
  EXPECT_GT(a.entries().size(), 10u);
  EXPECT_EQ(a.radius(), b.radius());
  for (std::size_t i = 0; i < a.entries().size(); ++i) {
    const auto &map = a.entries()[i].map, &other = b.entries()[i].map;
    ASSERT_EQ(map.grid().size(), other.grid().size());
    for (int y = 0; y < map.grid().height; ++y) {
      for (int x = 0; x < map.grid().width; ++x) ASSERT_EQ(map.texel(x, y), other.texel(x, y));
    }
  }
}

TEST(IlluminationMaps, SayWhatIsWrongWithTheirInput) {
  using State = IlluminationMaps::State;
  const auto state_of = [](const TinyScene& tiny, PhotonLight light = PhotonLight::all) {
    return Mapped(tiny, settings(2000, light)).maps.state();
  };
  const auto floor = geometry::Rectangle{{-2, -2, 0}, {4, 0, 0}, {0, 4, 0}};
  const description::PointLight point{{0, 0, 1}, {Quantity::intensity, white(1.0)}};
  const description::PointLight dark{{0, 0, 1}, {Quantity::intensity, white(0.0)}};
  EXPECT_EQ(state_of(TinyScene().add(floor, matte(0.5))), State::no_light);
  EXPECT_EQ(state_of(TinyScene().add(floor, matte(0.5)).light(dark)), State::no_light);
  EXPECT_EQ(state_of(TinyScene().add(floor, metal(1.0)).light(point)), State::nothing_arrives);
  EXPECT_EQ(state_of(TinyScene().light(point)), State::nothing_arrives);
  // Inside of an opaque body, which is full.
  EXPECT_EQ(state_of(TinyScene()
                         .add(floor, matte(0.5))
                         .light(point)
                         .add(geometry::Box{{-1, -1, 0.5}, {1, 1, 2}}, matte(0.9))),
            State::nothing_arrives);
  // Two mirrors that face each other, and white walls: an end comes all the same.
  EXPECT_EQ(state_of(TinyScene()
                         .add_outside(geometry::Box{}, metal(1.0))
                         .light(description::PointLight{{}, {Quantity::intensity, white(1.0)}})),
            State::nothing_arrives);

  const TinyScene tiny = TinyScene().add(floor, matte(0.5)).light(point);
  const auto message_of = [&](const IlluminationMaps::Settings& how) -> std::string {
    try {
      Mapped(tiny, how);
    } catch (const Error& error) {
      return error.problem();
    }
    return "none";
  };
  auto fine = settings(100, PhotonLight::all);
  fine.resolution = 1e6;
  EXPECT_EQ(message_of(fine), "maps of this resolution have 1.6e+13 texels");
  EXPECT_TRUE(
      message_of(settings(4'000'000'000u, PhotonLight::all)).starts_with("4000000000 photons"));
  EXPECT_EQ(message_of(settings(1, PhotonLight::all)), "none");
  EXPECT_EQ(message_of(settings(100, PhotonLight::all, 1e6)), "none");
}

}  // namespace
}  // namespace lapidary::test
