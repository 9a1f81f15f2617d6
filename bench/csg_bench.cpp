// The CSG sweep: rays a second through models of many operands, one thread, a primary ray a pixel
// and a shadow ray from each surface met; time and memory to build them. MODEL measures one of
// them, `--povray MODEL` writes it as a scene for POV-Ray.

#include <random>
#include <string>

#include "blob.h"
#include "csg_models.h"
#include "povray_scene.h"
#include "report.h"

namespace {

using namespace lapidary;
using namespace lapidary::bench;

constexpr View of_plate{{0, 13, -13}, {0, 0.5, 0}, 50, 0, {-8, 20, -6}};
constexpr View of_body{{2.6, 2.4, -4}, {0, 0, 0}, 42, -1.5, {-8, 20, -12}};
constexpr View of_mesh{{2.6, 2.4, -4}, {0, 0, 0}, 28, -1.5, {-8, 20, -12}};
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

struct Model {
  std::string name;
  View view;
  std::string_view target;  ///< in Mrays/s per core
  Term (*build)(Expression&);
};

const Model models[]{
    {"perforated.10", of_plate, ">=10", [](auto& e) { return perforated_plate(e, 5, 2); }},
    {"perforated.1000", of_plate, ">=7", [](auto& e) { return perforated_plate(e, 40, 25); }},
    {"perforated.100000", of_plate, ">=4", [](auto& e) { return perforated_plate(e, 400, 250); }},
    {"menger.3", of_body, "-", [](auto& e) { return menger_sponge(e, 3); }},
    {"menger.4", of_body, "-", [](auto& e) { return menger_sponge(e, 4); }},
    {"brilliant.half_spaces", of_body, "-", [](auto& e) { return brilliant_of_half_spaces(e); }},
    {"brilliant.polyhedron", of_body, "-", [](auto& e) { return brilliant_polyhedron(e); }},
    {"tree.8", of_body, "-", [](auto& e) { return AlternatingTree(e, 8).build(); }},
    {"tree.10", of_body, "-", [](auto& e) { return AlternatingTree(e, 10).build(); }},
};

void measure(const std::string& name, const geometry::World& world, const View& view,
             std::string_view target) {
  std::size_t rays = 0;
  double best = infinity;
  for (int run = 0; run < 3; ++run) {
    best = std::min(best, cpu_seconds([&] { rays = trace(world, view); }));
  }
  report("csg." + name + ".mrays_per_core", static_cast<double>(rays) / best / 1e6, "M/s", target);
  report("csg." + name + ".picture_seconds", best, "s");
}

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

/// A closed mesh of a million triangles: to prepare it, full lines through it without any order,
/// and a picture of it with a round hole drilled to its middle.
void million_triangles() {
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(blob());
  report("csg.mesh_body.build_seconds",
         best_cpu_seconds(2, [&] { geometry::make_mesh_body(mesh); }), "s", "<=1");
  const geometry::MeshBody body = geometry::make_mesh_body(mesh);
  const auto lines = lines_through(400000);
  geometry::EventBuffer events;
  const double query = best_cpu_seconds(3, [&] {
    for (const geometry::Line& line : lines) intervals(body, line, events);
  });
  report("csg.mesh_body.mlines_per_core", static_cast<double>(lines.size()) / query / 1e6, "M/s",
         ">=0.5");
  Expression expression;
  const Term term = drilled(expression, body, {{0, 0, 0}, {0.9, 1.2, -1.5}, 0.5});
  measure("mesh_minus_cylinder", world_of(std::move(expression), term, of_mesh), of_mesh, ">=0.5");
}

void million() {
  Expression expression;
  const Term plate = perforated_plate(expression, 1250, 800);
  std::optional<geometry::World> world;
  const double build =
      cpu_seconds([&] { world.emplace(world_of(std::move(expression), plate, of_plate)); });
  measure("perforated.1000000", *world, of_plate, ">=2.5");
  report("csg.build.million_seconds", build, "s", "<=2");
  report("csg.bytes_per_operand", static_cast<double>(world->solids().bytes()) / 1e6, "B", "<=300");
}

void measure(const Model& model) {
  Expression expression;
  const Term term = model.build(expression);
  measure(model.name, world_of(std::move(expression), term, model.view), model.view, model.target);
}

void write(const Model& model) {
  Expression expression;
  const Term term = model.build(expression);
  fmt::print("{}", povray_scene(expression, term, model.view));
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 1) {
    for (const Model& model : models) measure(model);
    million_triangles();
    million();
    return 0;
  }
  for (const Model& model : models) {
    if (model.name != arguments[count - 1]) continue;
    count == 2 ? measure(model) : write(model);
    return 0;
  }
  return 1;
}
