#include "render/canvas.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/render.h"
#include "same_canvas.h"
#include "scene/tiny_scene.h"
#include "support/random.h"

namespace lapidary::test {
namespace {

using film::Film;
using film::PassRange;
using render::Canvas;

/// A ball under a small lamp: much of it dark, some of it noisy.
struct SmallScene {
  scene::Scene scene = TinyScene()
                           .add(geometry::HalfSpace{{0, 0, -1}}, matte(0.5))
                           .add(geometry::Sphere{{0, 0, 0}, 0.7}, matte(0.9))
                           .add(geometry::Sphere{{1, -1, 2}, 0.3}, lamp(5.0))
                           .build();
  Film::Settings settings{.width = 12, .height = 9, .layers = film::Layers::all};
  ThreadPool pool{2};
  render::BlockRenderer renderer;

  explicit SmallScene(render::Sampling sampling = render::Sampling::adaptive)
      : renderer(scene, sampled(sampling), {settings.width, settings.height}, pool) {}

  static render::SampleSettings sampled(render::Sampling sampling) {
    render::SampleSettings settings = render::sample_settings({});
    settings.sampling = sampling;
    return settings;
  }

  Canvas empty() const { return Canvas(settings, renderer); }
  void go_on(Canvas& canvas, std::uint32_t samples) {
    render::render(renderer, {.samples = samples}, {}, canvas, pool);
  }
  Canvas rendered(std::uint32_t samples) {
    Canvas canvas = empty();
    go_on(canvas, samples);
    return canvas;
  }
  /// One block by itself, as another machine that knows the plan renders it.
  Film block(const PassRange& passes, const Canvas& canvas) {
    Film film(settings);
    std::optional<render::SamplePlan> plan = canvas.plan();
    renderer.render(passes, plan ? plan->map(passes.begin) : render::SampleMap(), film, pool);
    return film;
  }
};

// Whatever the numbers of samples are at which a render stops and goes on, in the middle of blocks
// and on both sides of decisions.
TEST(Canvas, DoesNotRememberWhereARenderStopped) {
  SmallScene small;
  const Canvas whole = small.rendered(37);
  EXPECT_EQ(whole.film().passes(), PassRange(0, 36));
  EXPECT_EQ(whole.picture().passes(), PassRange(0, 37));
  const auto& counts = whole.picture().state().samples;
  EXPECT_GT(std::accumulate(counts.begin(), counts.end(), 0u), 40u * counts.size()) << "uniform";
  Random random(1);
  for (int round = 0; round < 12; ++round) {
    Canvas canvas = small.empty();
    for (std::uint32_t samples = 0; samples < 37;) {
      samples = std::min(37u, samples + 1 + static_cast<std::uint32_t>(random.index(14)));
      small.go_on(canvas, samples);
      ASSERT_EQ(canvas.picture().pass_count(), samples);
    }
    expect_same(canvas, whole);
  }
}

// As the one who hands out blocks and gets them back, late and in any order.
TEST(Canvas, TakesBlocksInAnyOrder) {
  for (const auto sampling : {render::Sampling::adaptive, render::Sampling::uniform}) {
    SmallScene small(sampling);
    const Canvas whole = small.rendered(72);
    Random random(2);
    for (int round = 0; round < 6; ++round) {
      Canvas canvas = small.empty();
      std::vector<Film> on_their_way;
      std::uint32_t next = 0;
      while (next < 72 || !on_their_way.empty()) {
        const bool can_send = next < 72 && next < canvas.samples_known_until();
        if (can_send && (on_their_way.empty() || random.index(3) != 0)) {
          on_their_way.push_back(small.block({next, next + 4}, canvas));
          next += 4;
          continue;
        }
        ASSERT_FALSE(on_their_way.empty()) << "nobody may wait for more";
        const auto which = static_cast<std::ptrdiff_t>(random.index(on_their_way.size()));
        canvas.add(std::move(on_their_way[static_cast<std::size_t>(which)]));
        on_their_way.erase(on_their_way.begin() + which);
      }
      expect_same(canvas, whole);
    }
  }
}

// Parts that span no decision, in any order; then the decisions can be taken.
TEST(Canvas, AddsPartsOfManyBlocks) {
  SmallScene small;
  const Canvas whole = small.rendered(64);
  std::vector<Film> parts;
  for (const PassRange part : {PassRange{0, 8}, {8, 16}, {16, 32}, {32, 48}, {48, 64}}) {
    Film& film = parts.emplace_back(small.settings);
    for (std::uint32_t p = part.begin; p < part.end; p += 4) {
      film.add(small.block({p, p + 4}, whole));
    }
  }
  std::vector<std::size_t> order = {0, 1, 2, 3, 4};
  do {
    Canvas canvas = small.empty();
    for (const std::size_t i : order) canvas.add(parts[i]);
    canvas.settle();
    expect_same(canvas, whole);
  } while (std::ranges::next_permutation(order).found);
}

// What was summed before a decision was taken from its part cannot be told apart again: no decision
// is taken from the wrong passes, and nothing goes beyond it.
TEST(Canvas, GoesNoFurtherWhereADecisionCannotBeTaken) {
  SmallScene small;
  const Canvas whole = small.rendered(64);
  Canvas canvas = small.rendered(16);
  Film part(small.settings);
  for (std::uint32_t p = 24; p < 40; p += 4) part.add(small.block({p, p + 4}, whole));
  canvas.add(std::move(part));
  canvas.settle();
  EXPECT_EQ(canvas.samples_knowable_until(), 64u);
  EXPECT_NO_THROW(render::check_can_go_on(canvas, {.samples = 64}));
  EXPECT_THROW(render::check_can_go_on(canvas, {.samples = 65}), Error);
  EXPECT_THROW(render::check_can_go_on(canvas, {.seconds = 1.0}), Error);
  small.go_on(canvas, 64);
  EXPECT_EQ(canvas.film().state(), whole.film().state());
  EXPECT_EQ(canvas.samples_known_until(), 64u);
  EXPECT_EQ(whole.samples_known_until(), 256u);
}

TEST(Canvas, RendersSomeBlocksAlone) {
  SmallScene small;
  const Canvas whole = small.rendered(32), first = small.rendered(8);
  // Without a plan nothing is known of later passes; with it, of those that are decided.
  EXPECT_THROW(render::check_can_go_on(small.empty(), {.only = PassRange{8, 12}}), Error);
  EXPECT_NO_THROW(render::check_can_go_on(small.empty(), {.only = PassRange{0, 40}}));
  Canvas part(Film(small.settings), first.plan());
  EXPECT_NO_THROW(render::check_can_go_on(part, {.only = PassRange{8, 32}}));
  EXPECT_THROW(render::check_can_go_on(part, {.only = PassRange{8, 36}}), Error);
  for (const std::uint32_t end : {12u, 32u}) {  // stopped and gone on with
    render::render(small.renderer, {.only = PassRange{8, end}}, {}, part, small.pool);
    EXPECT_EQ(part.film().passes(), PassRange(8, end));
  }
  Canvas sum = first;
  sum.add(part.film());
  sum.settle();
  EXPECT_EQ(sum.film().state(), whole.film().state());
}

}  // namespace
}  // namespace lapidary::test
