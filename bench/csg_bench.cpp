// The CSG sweep: rays a second through models of many operands, one thread, a primary ray a pixel
// and a shadow ray from each surface met; time and memory to build them.

#include <string>

#include "csg_models.h"
#include "report.h"

namespace {

using namespace lapidary;
using namespace lapidary::bench;

struct View {
  Vec3d from, at;
  double angle;  ///< horizontal, degrees
  double floor;  ///< height of the plane below
  Vec3d light;
};

constexpr View of_plate{{0, 13, -13}, {0, 0.5, 0}, 50, 0, {-8, 20, -6}};
constexpr View of_body{{2.6, 2.4, -4}, {0, 0, 0}, 42, -1.5, {-8, 20, -12}};
constexpr int width = 800, height = 600;

geometry::World world_of(Expression expression, Term body, const View& view) {
  ThreadPool pool(1);
  geometry::World::Parts parts;
  geometry::Region plate, floor;
  plate.root = body;
  plate.medium = 1;
  floor.root = leaf(expression, geometry::HalfSpace{{0, view.floor, 0}, {0, 1, 0}});
  floor.medium = 2;
  parts.solids.expression = std::move(expression);
  parts.solids.regions = {plate, floor};
  return geometry::World(std::move(parts), pool);
}

/// Traces a picture; returns how many rays that took.
std::size_t trace(const geometry::World& world, const View& view) {
  const Vec3d forward = normalize(view.at - view.from);
  const Vec3d right = normalize(cross(forward, Vec3d{0, 1, 0})), up = cross(right, forward);
  const double tan_half = std::tan(0.5 * view.angle * pi / 180);
  std::size_t rays = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (2 * (x + 0.5) / width - 1) * tan_half;
      const double v = (1 - 2 * (y + 0.5) / height) * tan_half * height / width;
      const geometry::Ray ray{view.from, normalize(forward + right * u + up * v)};
      const geometry::Hit hit = world.nearest(ray);
      ++rays;
      if (hit.kind == geometry::SurfaceKind::none) continue;
      const geometry::Surface surface = world.surface(ray, hit);
      const Vec3d to_light = view.light - surface.p;
      if (dot(to_light, surface.geometric_normal) <= 0) continue;
      geometry::Ray shadow = geometry::World::leave(surface, to_light);
      shadow.t_max = 1.0;
      world.occluded(shadow);
      ++rays;
    }
  }
  return rays;
}

double mrays_per_core(const geometry::World& world, const View& view) {
  std::size_t rays = 0;
  double best = infinity;
  for (int run = 0; run < 3; ++run) {
    best = std::min(best, cpu_seconds([&] { rays = trace(world, view); }));
  }
  return static_cast<double>(rays) / best / 1e6;
}

void perforated(int columns, int rows, std::string_view target) {
  Expression expression;
  const Term plate = perforated_plate(expression, columns, rows);
  const geometry::World world = world_of(std::move(expression), plate, of_plate);
  report("csg.perforated." + std::to_string(columns * rows) + ".mrays_per_core",
         mrays_per_core(world, of_plate), "M/s", target);
}

void million() {
  Expression expression;
  const Term plate = perforated_plate(expression, 1250, 800);
  std::optional<geometry::World> world;
  const double build =
      cpu_seconds([&] { world.emplace(world_of(std::move(expression), plate, of_plate)); });
  report("csg.perforated.1000000.mrays_per_core", mrays_per_core(*world, of_plate), "M/s", ">=2.5");
  report("csg.build.million_seconds", build, "s", "<=2");
  report("csg.bytes_per_operand", static_cast<double>(world->solids().bytes()) / 1e6, "B", "<=300");
}

}  // namespace

/// With an argument, only models whose key contains it.
int main(int argc, char** argv) {
  const auto wanted = [&](std::string_view key) {
    return argc < 2 || key.find(argv[1]) != std::string_view::npos;
  };
  if (wanted("perforated.10.")) perforated(5, 2, ">=10");
  if (wanted("perforated.1000.")) perforated(40, 25, ">=7");
  if (wanted("perforated.100000.")) perforated(400, 250, ">=4");
  if (wanted("perforated.1000000.")) million();
  for (const int level : {3, 4}) {
    if (!wanted("menger." + std::to_string(level))) continue;
    Expression expression;
    const Term sponge = menger_sponge(expression, level);
    report("csg.menger." + std::to_string(level) + ".mrays_per_core",
           mrays_per_core(world_of(std::move(expression), sponge, of_body), of_body), "M/s");
  }
  for (const int depth : {8, 10}) {
    if (!wanted("tree." + std::to_string(depth))) continue;
    Expression expression;
    const Term tree = AlternatingTree(expression, depth).build();
    report("csg.tree." + std::to_string(depth) + ".mrays_per_core",
           mrays_per_core(world_of(std::move(expression), tree, of_body), of_body), "M/s");
  }
}
