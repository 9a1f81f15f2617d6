#include <cstdio>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "film/develop.h"
#include "image/image_io.h"
#include "render/render.h"
#include "scene/tiny_scene.h"

namespace lapidary::test {
namespace {

// The same scene, seed and passes give the same bits, however the work was divided. Compared as
// bits of every layer, not within anything.

constexpr int width = 37, height = 29;  // no multiple of any tile

/// A picture of a sky with a sun, in a file of this process's own that is removed again: every test
/// is a process, and several run at once.
class SkyFile {
 public:
  SkyFile()
      : path_(std::filesystem::path(testing::TempDir()) /
              ("lapidary_sky_" + std::to_string(getpid()) + ".exr")) {
    image::Image sky(16, 8);
    for (std::size_t i = 0; i < sky.pixels.size(); ++i) {
      sky.pixels[i] = 0.1f * static_cast<float>((i * 7) % 11);
    }
    sky.pixel(11, 2)[0] = sky.pixel(11, 2)[1] = sky.pixel(11, 2)[2] = 300.0f;
    image::write_image(path_, sky);
  }
  ~SkyFile() { std::filesystem::remove(path_); }
  SkyFile(const SkyFile&) = delete;
  SkyFile& operator=(const SkyFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Everything at once: dispersion, smooth and rough, solids, sheets, a mesh twice in the scene,
/// lights with and without a surface, a lens.
TinyScene varied_scene(const SkyFile& sky) {
  TinyScene tiny;
  tiny.description.render.size = {width, height};
  description::Perspective camera;
  camera.view = {{0.3, -6, 2}, {0, 0, 0.4}, {0, 0, 1}};
  camera.aperture = 0.2;
  tiny.description.camera = description::Camera{camera, {}};
  const auto red = material(description::Matte{Spectrum::reflectance({0.7f, 0.2f, 0.1f})});
  const auto gold = material(description::Metal{find_metal("gold").value(), 0.3});
  tiny.add(geometry::HalfSpace{{0, 0, -0.6}}, red);
  tiny.add(geometry::Sphere{{-1, 0, 0.4}, 0.8}, glass("N-SF11"));
  tiny.add(geometry::Box{{1.5, -1, -0.6}, {2.2, 0, 0.5}}, glass("N-BK7", 0.3));
  geometry::TriangleMesh smooth = ball_mesh(2);
  geometry::compute_smooth_normals(smooth);
  description::Mesh mesh;
  mesh.triangles = std::make_shared<const geometry::TriangleMesh>(smooth);
  tiny.add(mesh, gold,
           Transform::translation({0.8, 0.5, 0.4}) * Transform::scaling({0.7, 0.7, 0.7}));
  tiny.add(mesh, matte(0.9),
           Transform::translation({-2.2, 0, 0}) * Transform::scaling({0.4, 0.4, 0.6}));
  tiny.add(
      geometry::Disk{{0, 0, 3}, {0, 0, -1}, 0.4},
      material(description::Emissive{{description::Quantity::power, Spectrum::blackbody(4000)}}));
  tiny.light(description::ImageEnvironment{sky.path(), 1.0, 30.0});
  tiny.light(description::PointLight{{-3, -3, 2}, {}});
  return tiny;
}

struct Division {
  int threads = 1;
  int tile = 16;
  std::vector<render::PassRange> blocks = {{0, 4}, {4, 6}, {6, 7}, {7, 8}};
  std::uint64_t seed = 5;
};

image::LayeredImage rendered(const scene::Scene& scene, const Division& division) {
  ThreadPool pool(division.threads);
  const render::SampleSettings settings{
      {.max_depth = 12}, FilterSampler(FilterKind::blackman_harris, 1.5), division.seed};
  const render::BlockRenderer renderer(scene, settings, {width, height, division.tile}, pool);
  EXPECT_EQ(renderer.caustics().state(), transport::Caustics::State::active);
  film::Film film({.width = width, .height = height, .layers = film::Layers::all});
  for (const render::PassRange& block : division.blocks) renderer.render(block, film, pool);
  return film::develop(film);
}

bool same_bits(const image::Channel::Samples& a, const image::Channel::Samples& b) {
  const auto bytes = [](const auto& v) {
    return std::string_view(reinterpret_cast<const char*>(v.data()), v.size() * sizeof(v[0]));
  };
  if (a.index() != b.index()) return false;
  return std::visit(bytes, a) == std::visit(bytes, b);
}

void expect_same(const image::LayeredImage& a, const image::LayeredImage& b) {
  ASSERT_EQ(a.channels.size(), b.channels.size());
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    EXPECT_EQ(a.channels[i].name, b.channels[i].name);
    EXPECT_TRUE(same_bits(a.channels[i].samples, b.channels[i].samples)) << a.channels[i].name;
  }
}

class Determinism : public testing::Test {
 protected:
  SkyFile sky_;
  // Embree keeps the number of threads it was built with as a limit for the whole process.
  ThreadPool builders_{3};
  scene::Scene scene_ = varied_scene(sky_).build(builders_);
  image::LayeredImage reference_ = rendered(scene_, {});
};

TEST_F(Determinism, HoldsForAnyNumberOfThreads) {
  for (const int threads : {2, 3}) {
    SCOPED_TRACE(threads);
    expect_same(rendered(scene_, {.threads = threads}), reference_);
  }
}

TEST_F(Determinism, HoldsForAnyTiles) {
  for (const int tile : {1, 8, 64}) {
    SCOPED_TRACE(tile);
    expect_same(rendered(scene_, {.threads = 2, .tile = tile}), reference_);
  }
}

TEST_F(Determinism, HoldsForAnyOrderOfBlocks) {
  expect_same(rendered(scene_, {.blocks = {{7, 8}, {4, 6}, {0, 4}, {6, 7}}}), reference_);
  expect_same(rendered(scene_, {.threads = 2, .blocks = {{6, 7}, {0, 4}, {7, 8}, {4, 6}}}),
              reference_);
}

TEST_F(Determinism, HoldsForASceneBuiltAgain) {
  expect_same(rendered(varied_scene(sky_).build(builders_), {.threads = 2}), reference_);
  expect_same(rendered(varied_scene(sky_).build(), {}), reference_);  // by one thread
}

/// A picture whose pixels take different numbers of samples.
image::LayeredImage adaptive(const scene::Scene& scene, int threads) {
  ThreadPool pool(threads);
  const render::BlockRenderer renderer(scene, render::sample_settings({}), {width, height}, pool);
  render::Canvas canvas({.width = width, .height = height, .layers = film::Layers::all}, renderer);
  const auto done = render::render(renderer, {.samples = 20}, {}, canvas, pool);
  EXPECT_GT(done.tally.samples, 22u * width * height);
  return film::develop(canvas.picture());
}

TEST_F(Determinism, HoldsForAdaptiveSampling) {
  const image::LayeredImage one = adaptive(scene_, 1);
  expect_same(adaptive(scene_, 2), one);
  expect_same(adaptive(scene_, 3), one);
}

// How passes are grouped into blocks is not part of a sample: only the estimate of the variance,
// which is made from the blocks' means, may differ.
TEST_F(Determinism, OfTheMeansHoldsForAnyBlocks) {
  const auto other = rendered(scene_, {.blocks = {{0, 1}, {1, 8}}});
  for (std::size_t i = 0; i < other.channels.size(); ++i) {
    const std::string& name = other.channels[i].name;
    if (name.starts_with("variance")) continue;
    EXPECT_TRUE(same_bits(other.channels[i].samples, reference_.channels[i].samples)) << name;
  }
}

// The comparisons above compare something.
TEST_F(Determinism, IsNotThatOfAnEmptyPicture) {
  const auto other = rendered(scene_, {.seed = 6});
  for (std::size_t i = 0; i < other.channels.size(); ++i) {
    EXPECT_FALSE(same_bits(other.channels[i].samples, reference_.channels[i].samples))
        << other.channels[i].name;
  }
}

}  // namespace
}  // namespace lapidary::test
