#include <gtest/gtest.h>

#include "light/lights.h"
#include "support/chi_squared.h"

namespace lapidary::light {
namespace {

using lapidary::test::Random;
using test::Box;
using test::Cylinder;
using test::PlacedSolid;
using test::TriangleMesh;
using test::white;

LightNumbers numbers(Random& random) {
  const double part = random.uniform();
  return {part, random.uniform2()};
}

// Where a ray meets a light, found without the light's own code.
using Intersector = std::function<std::optional<LightHit>(Vec3d p, Vec3d wi)>;

std::optional<LightHit> meets_infinity(Vec3d, Vec3d) {
  return LightHit{};
}

Intersector meets_plane(Vec3d point, Vec3d normal, std::function<bool(Vec3d)> inside) {
  return [=](Vec3d p, Vec3d wi) -> std::optional<LightHit> {
    const double t = dot(point - p, normal) / dot(wi, normal);
    const Vec3d hit = p + t * wi;
    if (!(t > 0.0) || !inside(hit)) return std::nullopt;
    return LightHit{hit, normal};
  };
}

Intersector meets_sphere(Vec3d center, double radius) {
  return [=](Vec3d p, Vec3d wi) -> std::optional<LightHit> {
    const double b = dot(center - p, wi);
    const double d2 = length_squared(center - p - b * wi);
    if (b <= 0.0 || d2 >= radius * radius) return std::nullopt;
    const Vec3d hit = p + (b - std::sqrt(radius * radius - d2)) * wi;
    return LightHit{hit, normalize(hit - center)};
  };
}

// Seen through a frame that turns `axis` to the pole of the grid, so that cells fit the light.
void expect_fit(const Light& light, Vec3d p, const Intersector& meets, Vec3d axis,
                double min_cosine, int min_depth = 2) {
  const Frame frame = Frame::from_normal(normalize(axis));
  lapidary::test::Grid grid = lapidary::test::sphere_grid(16, 16);
  grid.min.y = min_cosine;
  const auto result = lapidary::test::test_directions(
      [&](Random& random) -> std::optional<Vec3d> {
        const auto s = sample_illumination(light, p, numbers(random), test::wavelengths());
        if (!s) return std::nullopt;
        const auto hit = meets(p, s->wi);
        EXPECT_TRUE(hit);
        if (hit && !is_infinite(light)) {
          EXPECT_NEAR(s->distance, length(hit->point - p), 1e-7 * s->distance);
        }
        if (hit) {
          const double pdf = pdf_illumination(light, p, s->wi, *hit);
          EXPECT_NEAR(pdf, s->pdf, 1e-7 * pdf);
          const SampledSpectrum L = emitted(light, s->wi, *hit, test::wavelengths());
          EXPECT_NEAR(L[0], s->L[0], 1e-5 * L[0] + 1e-12);
        }
        return frame.to_local(s->wi);
      },
      [&](Vec3d local) {
        const Vec3d wi = frame.to_world(local);
        const auto hit = meets(p, wi);
        return hit ? pdf_illumination(light, p, wi, *hit) : 0.0;
      },
      {.samples = 40000, .tests = 20, .min_depth = min_depth, .max_depth = 8}, grid);
  EXPECT_TRUE(result.accepted) << result.message;
}

// All fits of this file share a false-alarm rate of 1e-4.

TEST(Sampling, OfASphereFits) {
  const Vec3d center(1, 2, 3);
  const Light light = SphereLight(center, 0.5, white());
  for (const Vec3d p : {Vec3d(0, 0, 0), Vec3d(1, 2, 2.4)}) {
    const double sine = 0.5 / length(center - p);
    expect_fit(light, p, meets_sphere(center, 0.5), center - p, std::sqrt(1 - sine * sine) - 1e-9);
  }
}

TEST(Sampling, OfARectangleFitsBySolidAngleAndByArea) {
  const auto inside = [](Vec3d q) { return std::abs(q.x) <= 1.0 && std::abs(q.y) <= 0.5; };
  const Light light = RectangleLight({{-1, -0.5, 0}, {2, 0, 0}, {0, 1, 0}}, white());
  for (const Vec3d p : {Vec3d(0, 0, 1), Vec3d(1.2, -0.3, 0.1), Vec3d(0.3, 0.2, 30)})
    expect_fit(light, p, meets_plane({}, {0, 0, 1}, inside), -p, p.z > 2 ? 0.999 : -1.0, 4);
  // A leaning parallelogram.
  const auto leaning = [](Vec3d q) {
    return std::abs(q.y) <= 0.5 && std::abs(q.x - 0.5 * (q.y + 0.5)) <= 1.0;
  };
  const Light oblique = RectangleLight({{-1, -0.5, 0}, {2, 0, 0}, {0.5, 1, 0}}, white());
  expect_fit(oblique, {0.2, 0.1, 1}, meets_plane({}, {0, 0, 1}, leaning), {0, 0, -1}, 0.0, 4);
}

TEST(Sampling, OfADiskFits) {
  const Vec3d center(0, 1, 0), normal = normalize(Vec3d(1, 1, 1));
  const Light light = DiskLight({center, 2.0 * normal, 0.7}, white());
  const auto inside = [=](Vec3d q) { return length(q - center) <= 0.7; };
  expect_fit(light, {1, 1.5, 0.5}, meets_plane(center, normal, inside), {-1, -0.5, -0.5}, -1.0);
}

TEST(Sampling, OfAMeshFits) {
  // The flat square, then the triangle that leans over it: of both together a direction may meet
  // two points, whose densities add up.
  const std::vector<std::uint32_t> flat{0, 1}, top{2};
  const auto square = [](Vec3d q) { return std::abs(q.x) <= 1.0 && std::abs(q.y) <= 1.0; };
  expect_fit(MeshLight(test::roof(), flat, Transform(), white()), {0.3, -1.5, 0.8},
             meets_plane({}, {0, 0, 1}, square), {0, 0, -1}, -1.0);

  const Vec3d foot(0, 1, 0), leaning = normalize(cross(Vec3d(-2, 0, 0), Vec3d(-1, -1, 1.5)));
  const auto triangle = [](Vec3d q) {
    const double height = q.z / 1.5;
    return height >= 0.0 && height <= 1.0 && std::abs(q.x) <= 1.0 - height;
  };
  expect_fit(MeshLight(test::roof(), top, Transform(), white()), foot + leaning,
             meets_plane(foot, leaning, triangle), -leaning, -1.0);
}

TEST(Sampling, OfASolidFits) {
  const geometry::Box box{{-1, -1, -1}, {1, 1, 1}};
  const Transform place = Transform::translation({0, 0, 3}) * Transform::scaling({1, 2, 0.5});
  const Light light = SolidLight(PlacedSolid(box, place), white());
  const Vec3d p(0.5, 1, 0);
  const auto bottom = [](Vec3d q) { return std::abs(q.x) <= 1.0 && std::abs(q.y) <= 2.0; };
  const auto meets = [&](Vec3d from, Vec3d wi) {
    auto hit = meets_plane({0, 0, 2.5}, {0, 0, -1}, bottom)(from, wi);
    if (hit) hit->on_leaf.patch = 4;
    return hit;
  };
  expect_fit(light, p, meets, {0, 0, 1}, 0.0);
}

TEST(Sampling, OfASunFits) {
  const Vec3d towards = normalize(Vec3d(1, 1, 2));
  for (const double radius : {0.004, 0.5}) {
    const Light light = DistantLight({towards, radius}, white());
    expect_fit(light, {}, meets_infinity, towards, std::cos(radius) - 1e-12);
  }
}

TEST(Sampling, OfEnvironmentsFits) {
  expect_fit(ConstantEnvironment{white()}, {}, meets_infinity, {0, 0, 1}, -1.0);
  expect_fit(ImageEnvironment(test::sky()), {}, meets_infinity, {0, 0, 1}, -1.0);
  expect_fit(ImageEnvironment(test::sky(5, 3)), {}, meets_infinity, {1, 2, 3}, -1.0);
  expect_fit(ImageEnvironment({1, {Rgb{1, 1, 1}}, 0.0}), {}, meets_infinity, {0, 0, 1}, -1.0);
}

TEST(SphereLight, IsSampledHoweverFarOrNear) {
  Random random(2);
  for (const double distance : {1.0 + 1e-12, 1.0001, 10.0, 1e4, 1e7}) {
    const Vec3d towards = random.direction();
    const Light light = SphereLight(distance * towards, 1.0, white());
    for (int i = 0; i < 1000; ++i) {
      const auto s = sample_illumination(light, {}, numbers(random), test::wavelengths());
      ASSERT_TRUE(s);
      const Vec3d point = s->distance * s->wi;
      EXPECT_NEAR(length(point - distance * towards), 1.0, 1e-15 * distance * distance + 1e-8);
      EXPECT_GT(s->pdf, 0.0);
      EXPECT_TRUE(std::isfinite(s->pdf));
    }
  }
  const Light around = SphereLight({}, 2.0, white());
  EXPECT_FALSE(sample_illumination(around, {1, 0, 0}, {0.5, {0.5, 0.5}}, test::wavelengths()));
  EXPECT_EQ(pdf_illumination(around, {1, 0, 0}, {1, 0, 0}, {{2, 0, 0}, {1, 0, 0}}), 0.0);
  EXPECT_TRUE(emitted(around, {1, 0, 0}, {{2, 0, 0}, {1, 0, 0}}, test::wavelengths()).is_zero());
}

TEST(Lights, AreDarkFromBehind) {
  const std::vector<Light> lights{RectangleLight({{-1, -1, 0}, {2, 0, 0}, {0, 2, 0}}, white()),
                                  DiskLight({}, white()),
                                  MeshLight(test::roof(), Transform(), white())};
  for (const Light& light : lights) {
    const LightNumbers middle{0.1, {0.4, 0.4}};
    EXPECT_TRUE(sample_illumination(light, {0, -0.5, 1}, middle, test::wavelengths()));
    EXPECT_FALSE(sample_illumination(light, {0, -0.5, -1}, middle, test::wavelengths()));
    EXPECT_FALSE(sample_illumination(light, {5, 0, 0}, middle, test::wavelengths()));
    const LightHit hit{{0, -0.5, 0}, {0, 0, 1}};
    EXPECT_EQ(pdf_illumination(light, {0, -0.5, -1}, {0, 0, 1}, hit), 0.0);
    EXPECT_TRUE(emitted(light, {0, 0, 1}, hit, test::wavelengths()).is_zero());
    EXPECT_EQ(emitted(light, {0, 0, -1}, hit, test::wavelengths())[0], 1.0f);
  }
}

TEST(Lights, SurviveHostilePlaces) {
  const std::vector<Light> lights{SphereLight({}, 1.0, white()),
                                  RectangleLight({}, white()),
                                  DiskLight({}, white()),
                                  MeshLight(test::roof(), Transform(), white()),
                                  MeshLight(TriangleMesh(), Transform(), white()),
                                  SolidLight(PlacedSolid(Box{}, Transform()), white()),
                                  SolidLight(PlacedSolid(Cylinder{}, Transform()), white()),
                                  PointLight{{}, white()},
                                  SpotLight({}, {}, white()),
                                  DistantLight({}, white()),
                                  DistantLight({{0, 0, 1}, 1e-9}, white()),
                                  ImageEnvironment({1, {Rgb{}}, 0.0}),
                                  ImageEnvironment(test::sky())};
  const double below_one = 1.0 - 0x1p-53;
  const Vec3d places[] = {{},        {0, 0, 1e-300}, {0.5, 0.5, 0}, {0.5, 0.5, 1e-12}, {1, 0, 0},
                          {0, 0, 1}, {0, 0, 1e150},  {1e9, 1, 1},   {-0.5, 0.2, 1e-30}};
  for (const Light& light : lights) {
    for (const Vec3d p : places) {
      for (const double a : {0.0, 0.5, below_one}) {
        for (const double b : {0.0, 0.5, below_one}) {
          const auto s = sample_illumination(light, p, {b, {a, b}}, test::wavelengths());
          if (!s) continue;
          EXPECT_NEAR(length(s->wi), 1.0, 1e-9) << light.index();
          EXPECT_TRUE(s->pdf > 0.0 && std::isfinite(s->pdf)) << light.index();
          EXPECT_GE(s->L[0], 0.0f);
          EXPECT_GE(s->distance, 0.0) << light.index();
        }
      }
    }
  }
}

TEST(ImageEnvironment, LooksWhereThePictureSays) {
  ImageEnvironment::Picture picture{8, std::vector<Rgb>(32), 0.0};
  for (std::size_t x = 0; x < 8; ++x) picture.pixels[x] = {0, 0, 1};  // the top row
  picture.pixels[8 + 3] = picture.pixels[8 + 4] = {1, 0, 0};          // the middle
  picture.pixels[8 + 5] = picture.pixels[8 + 6] = {0, 1, 0};          // a quarter to the right
  const double up = std::cos(1.5 * pi / 4), out = std::sin(1.5 * pi / 4);
  const ImageEnvironment plain(picture);
  EXPECT_NEAR(plain.color_towards({0, 0, 1}).b, 1.0f, 1e-6);
  EXPECT_NEAR(plain.color_towards({0, out, up}).r, 1.0f, 1e-6);
  EXPECT_NEAR(plain.color_towards({out, 0, up}).g, 1.0f, 1e-6);
  EXPECT_NEAR(plain.color_towards({0, 0, -1}).r, 0.0f, 1e-6);
  picture.rotation = pi / 2;  // counter-clockwise: what was towards +x is towards +y
  EXPECT_NEAR(ImageEnvironment(picture).color_towards({0, out, up}).g, 1.0f, 1e-6);
}

}  // namespace
}  // namespace lapidary::light
