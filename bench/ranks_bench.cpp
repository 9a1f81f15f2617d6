// What a block costs between two ranks: its bytes, packing and unpacking them, and adding them up.
// How well ranks render together is measured by rendering: tools/bench.py.

#include <string>

#include "bench_scene.h"
#include "distributed/film_message.h"
#include "render/render.h"
#include "report.h"

namespace {

using namespace lapidary;

/// A block of four passes of a scene of bench/scenes, at its own size.
void measure(const std::string& name, film::Layers layers, const std::string& what) {
  bench::BenchScene stage(name);
  const render::BlockRenderer renderer(stage.scene,
                                       render::sample_settings(stage.description.render),
                                       {stage.size.width, stage.size.height}, stage.pool);
  const film::Film::Settings settings{.width = stage.size.width,
                                      .height = stage.size.height,
                                      .layers = layers,
                                      .scene_size = stage.scene.size()};
  distributed::RenderedRun run{{0, 4}, film::Film(settings), {}, 0};
  renderer.render(run.run, run.film, stage.pool);

  const auto pixels = static_cast<double>(settings.pixels());
  distributed::Message message;
  const double pack = bench::best_cpu_seconds(5, [&] { message = film_message(run); });
  const double unpack =
      bench::best_cpu_seconds(5, [&] { distributed::read_film_message(*message.bytes, settings); });
  const film::Film film = run.film;
  double add = 1e9;
  for (int i = 0; i < 5; ++i) {
    film::Film sum(settings);
    add = std::min(add, bench::cpu_seconds([&] { sum.add(film); }));
  }
  const std::string key = "ranks." + what;
  bench::report(key + ".block_bytes", static_cast<double>(message.bytes->size()) / pixels, "B/px");
  bench::report(key + ".pack", 1e9 * pack / pixels, "ns/px");
  bench::report(key + ".unpack", 1e9 * unpack / pixels, "ns/px");
  bench::report(key + ".add", 1e9 * add / pixels, "ns/px");
}

}  // namespace

int main() {
  measure("cornell_glass", film::Layers::all, "layers");
  measure("cornell_glass", film::Layers::beauty, "beauty");
}
