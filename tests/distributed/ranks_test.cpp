#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"
#include "distributed/byte_stream.h"
#include "distributed/local_channel.h"
#include "distributed/master.h"
#include "distributed/worker.h"
#include "render/same_canvas.h"
#include "scene/tiny_scene.h"

namespace lapidary::test {
namespace {

using distributed::Channel;
using distributed::Crew;
using distributed::Equipment;
using distributed::Orders;
using film::Film;
using film::PassRange;
using render::Canvas;
using render::Ending;

using Channels = std::vector<std::unique_ptr<Channel>>;

/// A ball of glass under a small lamp: dark, noisy and focused light.
struct SmallScene {
  scene::Scene scene = TinyScene()
                           .add(geometry::HalfSpace{{0, 0, -1}}, matte(0.5))
                           .add(geometry::Sphere{{0, 0, 0}, 0.7}, glass(1.5))
                           .add(geometry::Sphere{{1, -1, 2}, 0.3}, lamp(5.0))
                           .build();
  Film::Settings settings{.width = 12, .height = 9, .layers = film::Layers::all};
  ThreadPool pool{2};
  render::BlockRenderer renderer;

  explicit SmallScene(render::Sampling sampling = render::Sampling::adaptive,
                      transport::CausticMethod caustics = transport::CausticMethod::paths)
      : renderer(scene, sampled(sampling, caustics), {settings.width, settings.height}, pool) {}

  static render::SampleSettings sampled(render::Sampling sampling,
                                        transport::CausticMethod caustics) {
    render::SampleSettings settings = render::sample_settings({});
    settings.sampling = sampling;
    settings.path.caustics = caustics;
    return settings;
  }
  Equipment with(ThreadPool& other) const { return {renderer, settings, other}; }
  Canvas empty() const { return Canvas(settings, renderer); }

  Canvas alone(const render::StopRules& rules) {
    Canvas canvas = empty();
    render::render(renderer, rules, {}, canvas, pool);
    return canvas;
  }
};

/// Ranks 1, 2, ... as threads, from which nothing is expected but that they end.
class Others {
 public:
  Others(SmallScene& small, Channels& channels) {
    for (std::size_t rank = 1; rank < channels.size(); ++rank) {
      threads_.emplace_back([&small, &channel = *channels[rank]] {
        ThreadPool pool(1);
        Orders orders(channel);
        distributed::work(orders, small.with(pool));
      });
    }
  }
  ~Others() {
    for (std::thread& thread : threads_) thread.join();
  }
  Others(const Others&) = delete;
  Others& operator=(const Others&) = delete;

 private:
  std::vector<std::thread> threads_;
};

/// What a number of ranks makes of a canvas.
render::Statistics go_on(SmallScene& small, int ranks, const render::StopRules& rules,
                         Canvas& canvas, const render::Control& control = {}) {
  Channels channels = distributed::local_channels(ranks);
  const Others others(small, channels);
  Crew crew(*channels[0]);
  return distributed::render(crew, small.with(small.pool), rules, control, canvas);
}

TEST(Ranks, MakeThePictureOfOne) {
  using enum transport::CausticMethod;
  for (const auto sampling : {render::Sampling::adaptive, render::Sampling::uniform}) {
    for (const auto caustics : {paths, photons}) {
      SmallScene small(sampling, caustics);
      const std::uint32_t samples_asked = caustics == paths ? 75 : 34;
      const Canvas whole = small.alone({.samples = samples_asked});
      for (const int ranks : {1, 2, 5}) {
        Canvas canvas = small.empty();
        const auto statistics = go_on(small, ranks, {.samples = samples_asked}, canvas);
        expect_same(canvas, whole);
        EXPECT_EQ(statistics.ending, Ending::complete);
        const auto& counts = whole.picture().state().samples;
        std::uint64_t samples = 0;
        for (const std::uint32_t count : counts) samples += count;
        EXPECT_EQ(statistics.tally.samples, samples) << "what was rendered twice counts once";
      }
    }
  }
}

TEST(Ranks, GoOnAndFillGaps) {
  SmallScene small;
  const Canvas whole = small.alone({.samples = 64});
  for (const std::uint32_t before : {3u, 8u, 37u, 64u, 70u}) {
    Canvas canvas = small.alone({.samples = before});
    go_on(small, 3, {.samples = 64}, canvas);
    if (before <= 64) {
      expect_same(canvas, whole);
    } else {
      expect_same(canvas, small.alone({.samples = before}));
    }
  }
  Canvas part(Film(small.settings), whole.plan());
  go_on(small, 2, {.only = PassRange{24, 32}}, part);
  Canvas gap = small.alone({.samples = 16});
  gap.add(part.film());
  go_on(small, 3, {.samples = 64}, gap);
  expect_same(gap, whole);
}

TEST(Ranks, RenderSomeBlocksAlone) {
  SmallScene small;
  const Canvas whole = small.alone({.samples = 64});
  for (const PassRange only : {PassRange{0, 40}, {16, 64}, {28, 36}}) {
    Canvas alone(Film(small.settings), whole.plan()), shared = alone;
    render::render(small.renderer, {.only = only}, {}, alone, small.pool);
    const auto statistics = go_on(small, 3, {.only = only}, shared);
    EXPECT_EQ(statistics.ending, Ending::complete);
    EXPECT_EQ(shared.film().passes(), film::PassSet(only));
    expect_same(shared, alone);
  }
}

TEST(Ranks, StopAtTheNoiseAtWhichOneStops) {
  for (const auto sampling : {render::Sampling::adaptive, render::Sampling::uniform}) {
    SmallScene small(sampling);
    const double noise = small.alone({.samples = 48}).film().noise();
    for (const double rule : {1.2 * noise, 0.8 * noise}) {
      const Canvas whole = small.alone({.noise = rule});
      EXPECT_GT(whole.film().pass_count(), rule < noise ? 40u : 4u);
      for (const int ranks : {1, 3}) {
        Canvas canvas = small.empty();
        // Meanwhile more arrives than is wanted, and in any order.
        const render::Control slow{.on_block = [](const Canvas&) {
          std::this_thread::sleep_for(std::chrono::microseconds(500));
        }};
        const auto statistics = go_on(small, ranks, {.noise = rule}, canvas, slow);
        EXPECT_EQ(statistics.ending, Ending::complete);
        EXPECT_EQ(statistics.noise, whole.film().noise());
        expect_same(canvas, whole);
      }
    }
  }
}

TEST(Ranks, StopInTimeAndAllDeliver) {
  SmallScene small;
  for (const int ranks : {1, 3, 4}) {
    Canvas canvas = small.empty();
    // Of four ranks films are added in their order.
    const auto noise = ranks == 4 ? std::optional(1e-9) : std::nullopt;
    const auto statistics = go_on(small, ranks, {.seconds = 0.3, .noise = noise}, canvas);
    EXPECT_EQ(statistics.ending, Ending::out_of_time);
    EXPECT_GE(statistics.seconds, 0.2);
    EXPECT_GT(canvas.film().pass_count(), 0u);
    expect_same(canvas, small.alone({.samples = canvas.film().passes().end()}));
  }
}

TEST(Ranks, StopWhenTheyAreTold) {
  SmallScene small;
  std::atomic<bool> stop = false;
  Canvas canvas = small.empty();
  int blocks = 0;
  const render::Control control{.on_block = [&](const Canvas&) { stop = ++blocks >= 3; },
                                .stop = &stop};
  const auto statistics = go_on(small, 3, {.samples = 1 << 20}, canvas, control);
  EXPECT_EQ(statistics.ending, Ending::interrupted);
  // Whatever the gaps are, they can be filled.
  const std::uint32_t end = std::max(32u, canvas.film().passes().end());
  go_on(small, 2, {.samples = end}, canvas);
  expect_same(canvas, small.alone({.samples = end}));
}

TEST(Ranks, DoNotWaitForOneThatDoesNothing) {
  SmallScene small;
  Channels channels = distributed::local_channels(3);
  std::thread sleeper([&] {
    Orders orders(*channels[1]);
    while (!orders.are_over()) {
      if (!orders.poll()) distributed::nap(orders.channel());
    }
    orders.take_leave();
  });
  std::thread worker([&] {
    ThreadPool pool(1);
    Orders orders(*channels[2]);
    distributed::work(orders, small.with(pool));
  });
  Canvas canvas = small.empty();
  {
    Crew crew(*channels[0]);
    distributed::render(crew, small.with(small.pool), {.samples = 64}, {}, canvas);
  }
  sleeper.join();
  worker.join();
  expect_same(canvas, small.alone({.samples = 64}));
}

TEST(Ranks, SayWhatIsWrong) {
  const auto message_of = [](const std::function<void(Orders&)>& bad_rank) {
    SmallScene small;
    Channels channels = distributed::local_channels(2);
    std::thread other([&] {
      Orders orders(*channels[1]);
      bad_rank(orders);
    });
    std::string message;
    Canvas canvas = small.empty();
    try {
      Crew crew(*channels[0]);
      distributed::render(crew, small.with(small.pool), {.samples = 1 << 20}, {}, canvas);
    } catch (const Error& error) {
      message = error.what();
    }
    other.join();
    return message;
  };
  EXPECT_NE(message_of([](Orders& orders) {
              distributed::fail(orders, "no memory");
            }).find("rank 1: no memory"),
            std::string::npos);
  const std::string broken = message_of([](Orders& orders) {
    orders.channel().send(0, {distributed::Topic::film});
    while (!orders.are_over()) {
      if (!orders.poll()) distributed::nap(orders.channel());
    }
    orders.take_leave();
  });
  EXPECT_NE(broken.find("is broken"), std::string::npos) << broken;
}

TEST(Ranks, PassOnWhatIsForAll) {
  for (int ranks = 1; ranks <= 9; ++ranks) {
    Channels channels = distributed::local_channels(ranks);
    std::vector<std::thread> threads;
    std::vector<int> heard(static_cast<std::size_t>(ranks), 0);
    for (int rank = 1; rank < ranks; ++rank) {
      threads.emplace_back([&, rank] {
        const auto r = static_cast<std::size_t>(rank);
        Orders orders(*channels[r]);
        while (!orders.are_over()) {
          const auto order = orders.poll();
          if (order && distributed::read_pass_message(*order->bytes).begin ==
                           static_cast<std::uint32_t>(heard[r])) {
            ++heard[r];
          }
        }
        orders.take_leave();
      });
    }
    {
      Crew crew(*channels[0]);
      for (std::uint32_t i = 0; i < 20; ++i) {
        send_on(*channels[0], distributed::pass_message(distributed::Topic::epoch, {i, i}));
      }
      EXPECT_TRUE(crew.wait(60));
    }
    for (std::thread& thread : threads) thread.join();
    for (int rank = 1; rank < ranks; ++rank) EXPECT_EQ(heard[static_cast<std::size_t>(rank)], 20);
  }
}

}  // namespace
}  // namespace lapidary::test
