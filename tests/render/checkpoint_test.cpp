#include "render/checkpoint.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "film/develop.h"
#include "render/render.h"
#include "scene/tiny_scene.h"
#include "support/random.h"

namespace lapidary::test {
namespace {

using render::Canvas;
using render::Checkpoint;
using render::Origin;
using testing::ElementsAre;
using testing::HasSubstr;

Origin some_origin() {
  return {"0.1.0",
          "scene.lua",
          {{"max_depth", "16"}, {"samples", "64"}, {"size", "{12, 9}"}, {"time", ""}},
          {{"name", "two\nlines \\ and = signs"}, {"empty", ""}},
          {{"scene.lua", std::string(64, 'a')}, {"textures/\\ odd\nname", std::string(64, 'b')}}};
}

TEST(Origin, SurvivesBeingWrittenAsLines) {
  const Origin origin = some_origin();
  EXPECT_EQ(render::parse_lines(render::to_lines(origin.settings)), origin.settings);
  EXPECT_EQ(render::parse_lines(render::to_lines(origin.parameters)), origin.parameters);
  EXPECT_EQ(render::parse_file_lines(render::to_lines(origin.files)), origin.files);
  EXPECT_EQ(render::to_lines(std::span(origin.files).first(1)),
            std::string(64, 'a') + "  scene.lua\n");
}

TEST(Origin, NamesWhatDiffers) {
  const Origin then = some_origin();
  EXPECT_THAT(differences(then, then), ElementsAre());
  Origin now = then;
  now.scene = "other.lua";
  now.settings[1].second = "128";  // more samples, and until then
  now.settings[3].second = "5";
  EXPECT_THAT(differences(then, now), ElementsAre());
  now.version = "0.2.0";
  now.settings[0].second = "8";
  now.parameters.pop_back();
  now.files[0].sha256[3] = 'c';
  now.files[1].name = "new.png";
  EXPECT_THAT(differences(then, now),
              ElementsAre("Lapidary 0.1.0, now 0.2.0", "setting max_depth: 16, now 8",
                          "parameter empty: none, now none", "file new.png: was not read then",
                          "file scene.lua: has other content now",
                          "file textures/\\ odd\nname: is not read now"));
}

/// A render of 20 samples in a file of this test's own.
class CheckpointFile : public testing::Test {
 protected:
  CheckpointFile() {
    std::string name = (std::filesystem::temp_directory_path() / "lapidary-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~CheckpointFile() override { std::filesystem::remove_all(folder_); }

  std::string path() const { return folder_ / "a.exr"; }

  Canvas rendered(render::Sampling sampling, film::Layers layers, std::uint32_t samples) {
    render::SampleSettings settings = render::sample_settings({});
    settings.sampling = sampling;
    const render::BlockRenderer renderer(scene_, settings, {12, 9}, pool_);
    Canvas canvas({.width = 12, .height = 9, .layers = layers, .exposure_factor = 0.1}, renderer);
    render::render(renderer, {.samples = samples}, {}, canvas, pool_);
    return canvas;
  }
  void write(const Canvas& canvas, const image::Attachment& attachment) const {
    image::write_image(path(), film::develop(canvas.picture()), attachment);
  }
  std::string problem() const {
    try {
      render::read_checkpoint(path());
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path folder_;
  ThreadPool pool_{1};
  scene::Scene scene_ = TinyScene()
                            .add(geometry::HalfSpace{{0, 0, -1}}, matte(0.5))
                            .add(geometry::Sphere{{0, 0, 0}, 0.7}, matte(0.9))
                            .add(geometry::Sphere{{1, -1, 2}, 0.3}, lamp(5.0))
                            .build();
};

TEST_F(CheckpointFile, HoldsEverything) {
  for (const auto sampling : {render::Sampling::adaptive, render::Sampling::uniform}) {
    for (const auto layers : {film::Layers::beauty, film::Layers::all}) {
      const Canvas canvas = rendered(sampling, layers, 18);
      for (const auto compression : {image::Compression::zip, image::Compression::none}) {
        image::write_image(path(), film::develop(canvas.picture()),
                           render::checkpoint_of(some_origin(), canvas),
                           {.compression = compression});
        const Checkpoint read = render::read_checkpoint(path());
        EXPECT_EQ(read.origin, some_origin());
        EXPECT_EQ(read.canvas.film().state(), canvas.film().state());
        ASSERT_EQ(read.canvas.plan().has_value(), canvas.plan().has_value());
        if (!canvas.plan()) continue;
        EXPECT_EQ(read.canvas.plan()->epochs(), canvas.plan()->epochs());
        EXPECT_EQ(read.canvas.plan()->photons(), canvas.plan()->photons());
      }
    }
  }
}

// More epochs than share a channel; counts over the whole of their range.
TEST_F(CheckpointFile, HoldsManyEpochs) {
  Random random(4);
  std::vector<render::Allocation> epochs(19);
  for (auto& epoch : epochs) {
    epoch.photons = random.uniform(1, 4);
    for (int i = 0; i < 12 * 9; ++i) {
      epoch.counts.push_back(static_cast<std::uint8_t>(1 + random.index(16)));
    }
  }
  const Canvas canvas(film::Film({.width = 12, .height = 9}),
                      render::SamplePlan({0.1, 1.0 / 3.0}, 12, 9, epochs));
  write(canvas, render::checkpoint_of(some_origin(), canvas));
  EXPECT_EQ(render::read_checkpoint(path()).canvas.plan()->epochs(), epochs);
}

TEST_F(CheckpointFile, OfAnotherKindIsRefused) {
  const Canvas canvas = rendered(render::Sampling::adaptive, film::Layers::all, 8);
  const auto broken = [&](const auto& change) {
    image::Attachment attachment = render::checkpoint_of(some_origin(), canvas);
    change(attachment);
    write(canvas, attachment);
    return problem();
  };
  EXPECT_EQ(broken([](const auto&) {}), "accepted");
  const auto stated = [&](const std::string& name, const auto& value) {
    return broken([&](image::Attachment& attachment) {
      std::ranges::find(attachment.metadata, name, &image::Attribute::name)->value = value;
    });
  };
  EXPECT_THAT(stated("checkpoint", 2.0), HasSubstr("of format 2, made by Lapidary 0.1.0"));
  for (const auto& [name, text] :
       std::vector<std::pair<std::string, std::string>>{{"passes", "0-6"},
                                                        {"passes", "0-4,4-8"},
                                                        {"passes", "x"},
                                                        {"layers", "some"},
                                                        {"scene_size", "0"},
                                                        {"scene_size", "nan"},
                                                        {"exposure_factor", "-1"},
                                                        {"not_finite", "-1"},
                                                        {"photon_cost", "inf "},
                                                        {"epochs", "1"},
                                                        {"epochs", "1 0"},
                                                        {"epochs", "1 1 1 1 1 1 1 1 1 1"},
                                                        {"passes", "0-16"}}) {
    EXPECT_THAT(stated(name, text), HasSubstr("checkpoint is broken")) << name << text;
  }
  for (const char* name : {"sum.R.lo", "square.B.hi", "samples", "object", "counts.0"}) {
    EXPECT_THAT(broken([&](image::Attachment& attachment) {
                  std::erase_if(attachment.channels, [&](const auto& c) { return c.name == name; });
                }),
                HasSubstr(name));
  }
  EXPECT_THAT(broken([](image::Attachment& a) { a.name = "other"; }), HasSubstr("no checkpoint"));
  image::write_image(path(), film::develop(canvas.picture()));
  EXPECT_THAT(problem(), HasSubstr("a.exr: holds no checkpoint"));
}

// Files with a bit or a piece that is wrong: an error, or what nobody can tell from a checkpoint,
// and never anything worse.
TEST_F(CheckpointFile, ThatIsDamagedDoesNoHarm) {
  const Canvas canvas = rendered(render::Sampling::adaptive, film::Layers::beauty, 8);
  write(canvas, render::checkpoint_of(some_origin(), canvas));
  std::ifstream in(path(), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  Random random(6);
  int refused = 0;
  for (int round = 0; round < 300; ++round) {
    std::string damaged = bytes;
    if (round % 10 == 0) damaged.resize(random.index(bytes.size()));
    for (std::uint64_t i = random.index(4); i > 0 && !damaged.empty(); --i) {
      damaged[random.index(std::min<std::size_t>(damaged.size(), 4000))] =
          static_cast<char>(random.bits());
    }
    std::filesystem::remove(path());
    std::ofstream(path(), std::ios::binary) << damaged;
    refused += problem() != "accepted";
  }
  EXPECT_GT(refused, 30);
}

}  // namespace
}  // namespace lapidary::test
