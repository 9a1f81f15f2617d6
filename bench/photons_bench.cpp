// How many photons of a caustic are stored per second on one core: emitted, followed, and sorted
// into the map of their pass. What they are worth is measured by rendering: tools/bench.py.

#include <string>
#include <vector>

#include "bench_scene.h"
#include "report.h"
#include "transport/caustics.h"

namespace {

using namespace lapidary;

/// Passes of a scene of bench/scenes, at its own size.
void measure(const std::string& name, std::string_view target) {
  bench::BenchScene stage(name);
  const transport::Caustics caustics(stage.scene,
                                     {.max_depth = stage.description.render.max_depth,
                                      .width = stage.size.width,
                                      .height = stage.size.height},
                                     stage.pool);
  constexpr std::uint32_t passes = 16;
  transport::Counters counters;
  const auto run = [&] {
    counters = {};
    for (std::uint32_t pass = 0; pass < passes; ++pass) {
      const Heroes wavelengths =
          every_hero(Wavelengths::sample(Wavelengths::pass_stratum(pass, 0.0)));
      caustics.trace({pass, 1.0, static_cast<double>(pass)}, wavelengths, stage.pool, counters);
    }
  };
  const double seconds = bench::best_cpu_seconds(5, run);
  const auto emitted = static_cast<double>(counters.photons_emitted);
  const auto left = static_cast<double>(counters.photons_left);
  bench::report("photons." + name + ".stored", 1e-6 * left / seconds, "M/s", target);
  bench::report("photons." + name + ".emitted", 1e-6 * emitted / seconds, "M/s");
  bench::report("photons." + name + ".left_of_emitted", left / emitted, "share");
  const auto rays = static_cast<double>(counters.nearest_queries);
  bench::report("photons." + name + ".rays", 1e-6 * rays / seconds, "M/s");
  bench::report("photons." + name + ".rays_of_emitted", rays / emitted, "1");
}

}  // namespace

int main() {
  measure("lens", ">=1.0");
  measure("cornell_glass", "-");
}
