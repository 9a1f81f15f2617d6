// A million triangles as a solid: how long it takes to prepare them, and how many full lines a
// second one thread answers.

#include <random>
#include <vector>

#include "blob.h"
#include "geometry/mesh_body.h"
#include "report.h"

namespace {

using namespace lapidary;

std::vector<geometry::Line> lines_through(std::size_t count) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> gauss;
  const auto direction = [&] {
    return normalize(Vec3d{gauss(random), gauss(random), gauss(random)});
  };
  std::vector<geometry::Line> lines(count);
  for (geometry::Line& line : lines) {
    line.origin = direction() * 2.0;
    line.direction = direction() * 0.9 - line.origin;
  }
  return lines;
}

}  // namespace

int main() {
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(bench::blob());
  const double build = bench::best_cpu_seconds(2, [&] { geometry::make_mesh_body(mesh); });
  bench::report("mesh_body.build_1m", build, "s", "<=1");
  const geometry::MeshBody body = geometry::make_mesh_body(mesh);
  const auto lines = lines_through(400000);
  geometry::EventBuffer events;
  std::size_t crossings = 0;
  const double query = bench::best_cpu_seconds(3, [&] {
    crossings = 0;
    for (const geometry::Line& line : lines) {
      intervals(body, line, events);
      crossings += events.size();
    }
  });
  const auto count = static_cast<double>(lines.size());
  bench::report("csg.mesh_body.mlines_per_core", count / query * 1e-6, "M/s", ">=0.5");
  bench::report("mesh_body.events_per_line", static_cast<double>(crossings) / count, "events");
}
