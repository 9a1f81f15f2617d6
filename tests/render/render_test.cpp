#include "render/render.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/tiny_scene.h"

namespace lapidary::test {
namespace {

using render::PassRange;
using render::Progress;
using render::StopRules;

/// A small noisy scene with a film for it.
struct SmallRender {
  scene::Scene scene = TinyScene()
                           .add(geometry::HalfSpace{{0, 0, -1}}, matte(0.5))
                           .add(geometry::Sphere{{1, -1, 2}, 0.5}, lamp(5.0))
                           .build();
  ThreadPool pool{1};
  render::BlockRenderer renderer{scene, render::sample_settings({}), {8, 6}, pool};
  render::Canvas canvas{{.width = 8, .height = 6}, renderer};

  render::Statistics operator()(const StopRules& rules, const render::Control& control = {}) {
    return render::render(renderer, rules, control, canvas, pool);
  }
  const film::Film& film() const { return canvas.picture(); }
};

TEST(Render, StopsAtTheSamplesAskedFor) {
  for (const std::uint32_t samples : {1u, 4u, 10u}) {
    SmallRender run;
    std::vector<std::uint64_t> passes;
    const auto statistics = run({.samples = samples}, {.on_progress = [&](const Progress& p) {
                                  passes.push_back(p.passes);
                                  EXPECT_EQ(p.passes_planned, samples);
                                  EXPECT_GE(p.seconds_left.value(), 0.0);
                                }});
    EXPECT_EQ(statistics.ending, render::Ending::complete);
    EXPECT_EQ(run.film().pass_count(), samples);
    EXPECT_EQ(passes.size(), (samples + 3) / 4);
    EXPECT_EQ(passes.back(), samples);
    EXPECT_GE(statistics.tally.counters.nearest_queries, 48 * samples);
  }
}

TEST(Render, NeverStopsBeforeABlockIsWhole) {
  SmallRender run;
  const std::atomic<bool> stop = true;
  const auto statistics = run({.seconds = 0.0}, {.stop = &stop});
  EXPECT_EQ(run.film().pass_count(), 4u);
  EXPECT_EQ(run.film().blocks(), 1u);
  EXPECT_EQ(statistics.ending, render::Ending::out_of_time);
}

TEST(Render, IsCompleteOnlyWithWhatWasAskedFor) {
  EXPECT_EQ(SmallRender()({.samples = 4, .seconds = 0.0}).ending, render::Ending::complete);
  EXPECT_EQ(SmallRender()({.samples = 5, .seconds = 0.0}).ending, render::Ending::out_of_time);
  EXPECT_EQ(SmallRender()({.seconds = 60.0, .noise = 1e9}).ending, render::Ending::complete);
}

TEST(Render, StopsWhenItIsTold) {
  SmallRender run;
  std::atomic<bool> stop = false;
  const auto statistics =
      run({.samples = 1000},
          {.on_progress = [&](const Progress& p) { stop = p.passes >= 12; }, .stop = &stop});
  EXPECT_EQ(run.film().pass_count(), 12u);
  EXPECT_EQ(statistics.ending, render::Ending::interrupted);
}

TEST(Render, StopsAtTheNoiseAskedFor) {
  SmallRender run;
  const double before = [&] {
    SmallRender few;
    return few({.samples = 8}).noise;
  }();
  const auto statistics = run({.noise = 0.3 * before});
  EXPECT_LE(statistics.noise, 0.3 * before);
  EXPECT_GT(run.film().pass_count(), 8u);
  EXPECT_EQ(statistics.noise, run.film().noise());
}

// Going on with a film is the same as not having stopped.
TEST(Render, GoesOnWhereItStopped) {
  SmallRender whole, parts;
  whole({.samples = 12});
  parts({.samples = 4});
  parts({.samples = 12});
  EXPECT_EQ(parts.film().pass_count(), 12u);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(parts.film().beauty(x, y), whole.film().beauty(x, y));
      EXPECT_EQ(parts.film().variance(x, y), whole.film().variance(x, y));
    }
  }
}

TEST(StopRules, AreThoseOfTheScene) {
  description::RenderSettings settings;
  EXPECT_EQ(render::stop_rules(settings).samples, 256u);
  settings.noise = 0.02;
  EXPECT_EQ(render::stop_rules(settings).samples, std::nullopt);
  EXPECT_EQ(render::stop_rules(settings).noise, 0.02);
  settings.samples = 7;
  settings.time = 3.5;
  EXPECT_EQ(render::stop_rules(settings).samples, 7u);
  EXPECT_EQ(render::stop_rules(settings).seconds, 3.5);
}

TEST(CheckSize, RefusesPicturesThatNobodyCanHold) {
  EXPECT_NO_THROW(render::check_size({1, 1}));
  EXPECT_NO_THROW(render::check_size({16384, 16384}));
  EXPECT_THROW(render::check_size({0, 10}), Error);
  EXPECT_THROW(render::check_size({10, 0}), Error);
  EXPECT_THROW(render::check_size({-3, 10}), Error);
  EXPECT_THROW(render::check_size({16384, 16385}), Error);
  EXPECT_THROW(render::check_size({INT32_MAX, INT32_MAX}), Error);
}

}  // namespace
}  // namespace lapidary::test
