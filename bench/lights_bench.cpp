// How long it takes to build the hierarchy of very many lights, the memory that it takes, and what
// a choice costs. Which error it has is measured by rendering: tools/bench.py.

#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "light/light_selector.h"
#include "report.h"

namespace {

using namespace lapidary;

/// Lamps over a square of side 100, half of them balls and half of them panels that look down.
std::vector<light::Light> lamps(std::size_t count) {
  std::mt19937_64 engine(1);
  const auto uniform = [&] { return static_cast<double>(engine() >> 11) * 0x1p-53; };
  std::vector<light::Light> lights;
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3d at{100 * uniform(), 100 * uniform(), uniform()};
    const Spectrum L = Spectrum::illuminant({1, 1, 1}).scaled(static_cast<float>(uniform()));
    if (i % 2 == 0) {
      lights.push_back(light::SphereLight(at, 0.02, L));
    } else {
      lights.push_back(light::RectangleLight({at, {0, 0.08, 0}, {0.08, 0, 0}}, L));
    }
  }
  return lights;
}

void measure(std::size_t count) {
  const std::vector<light::Light> lights = lamps(count);
  std::vector<light::Influence> influences;
  const double look = bench::cpu_seconds([&] {
    for (const light::Light& light : lights) influences.push_back(light::influence(light));
  });
  const std::string group = fmt::format("lights.{}", count);
  bench::report(group + ".influences_ms", 1e3 * look, "ms");
  std::optional<light::ManyLights> many;
  const double build = bench::best_cpu_seconds(3, [&] { many.emplace(influences); });
  bench::report(group + ".build_ms", 1e3 * build, "ms");
  const double each = static_cast<double>(many->bytes()) / static_cast<double>(count);
  bench::report(group + ".bytes_per_light", each, "B", "<=136");

  constexpr int choices = 200000;
  double sum = 0;
  const double choose = bench::best_cpu_seconds(3, [&] {
    for (int i = 0; i < choices; ++i) {
      const double u = std::fmod(i * 0.6180339887, 1.0), v = std::fmod(i * 0.7548776662, 1.0);
      sum += many->choose({{100 * u, 100 * v, 0}, {0, 0, 1}}, std::fmod(1e3 * v, 1.0)).probability;
    }
  });
  if (!(sum > 0)) fmt::print(stderr, "no light was chosen\n");
  bench::report(group + ".choice_ns", 1e9 * choose / choices, "ns");
}

}  // namespace

int main() {
  measure(10000);
  measure(1000000);
}
