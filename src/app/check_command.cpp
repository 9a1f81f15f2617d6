#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "app/commands.h"
#include "app/load_scene.h"
#include "app/messages.h"
#include "inspect/report.h"
#include "scene/build.h"

namespace lapidary::app {
namespace {

using inspect::ObjectReport;
using inspect::SceneReport;

/// Longer lists are cut: a scene may have a million objects.
constexpr std::size_t longest_list = 50;

std::string number_or(const std::optional<double>& value, const char* otherwise) {
  return value ? fmt::format("{:.6g}", *value) : otherwise;
}

/// "'lid' (scene.lua:7)", as far as known.
std::string label(const ObjectReport& object) {
  const std::string name = object.name.empty() ? object.kind : fmt::format("'{}'", object.name);
  return object.where.file.empty() ? name : fmt::format("{} ({})", name, to_string(object.where));
}

void print_more(std::size_t total) {
  if (total > longest_list) fmt::print("  and {} more\n", total - longest_list);
}

void print_objects(const SceneReport& report) {
  fmt::print("\n  {:<11}{:>10}  {:<7}{:>12}{:>14}  {}\n", "kind", "triangles", "closed", "area",
             "volume", "object");
  for (std::size_t i = 0; i < std::min(report.objects.size(), longest_list); ++i) {
    const ObjectReport& object = report.objects[i];
    fmt::print("  {:<11}{:>10}  {:<7}{:>12}{:>14}  {}\n", object.kind, object.triangles,
               object.closed ? "yes" : "no", number_or(object.measure.area, "infinite"),
               number_or(object.measure.volume, object.closed ? "infinite" : "-"), label(object));
  }
  print_more(report.objects.size());
}

/// What is wrong with the surface of a mesh, or empty.
std::string mesh_problem(const ObjectReport& object) {
  if (!object.closure) return "";
  const geometry::MeshClosure& closure = *object.closure;
  std::string problem;
  if (!closure.closed()) {
    problem = fmt::format("{} open and {} wrongly turned edges", closure.open_edges,
                          closure.misoriented_edges);
    if (const auto& p = closure.example) {
      problem += fmt::format(", one near {:.4g}, {:.4g}, {:.4g} of the mesh", p->x, p->y, p->z);
    }
  } else if (object.measure.volume.value_or(0) < 0) {
    problem = "inside out: its triangles are clockwise seen from outside";
  }
  if (closure.degenerate_triangles > 0) {
    problem += fmt::format("{}{} triangles without area", problem.empty() ? "" : "; ",
                           closure.degenerate_triangles);
  }
  return problem;
}

void print_mesh_problems(const SceneReport& report) {
  std::size_t count = 0;
  for (const ObjectReport& object : report.objects) {
    const std::string problem = mesh_problem(object);
    if (problem.empty()) continue;
    if (count == 0) fmt::print("\nmeshes to look at:\n");
    if (++count <= longest_list) fmt::print("  {}: {}\n", label(object), problem);
  }
  print_more(count);
}

void print_overlaps(const SceneReport& report) {
  const auto& [overlaps, complete] = report.overlaps;
  if (!overlaps.empty()) fmt::print("\nobjects that share a part of their insides:\n");
  for (std::size_t i = 0; i < std::min(overlaps.size(), longest_list); ++i) {
    fmt::print("  {} and {}\n", label(report.objects[overlaps[i].first]),
               label(report.objects[overlaps[i].second]));
  }
  print_more(overlaps.size());
  if (!complete) fmt::print("  there are too many pairs to look at all of them\n");
}

}  // namespace

ExitCode run(const CheckCommand& command) {
  ThreadPool pool;
  WarningLog warnings;
  auto description = load_scene(command.scene, {}, warnings);
  const SceneReport report = inspect::inspect(description);
  fmt::print("{}: {} objects, {} operands, {} triangles, {} lights\n", command.scene.file,
             report.objects.size(), report.operands, report.triangles, report.lights);
  print_objects(report);
  print_mesh_problems(report);
  print_overlaps(report);
  std::fflush(stdout);
  // What a renderer would refuse, building the scene refuses.
  complete_scene(command.scene, description);
  scene::build(description, {description.render.size, pool, warnings});
  print_warnings(warnings.take());
  return ExitCode::done;
}

}  // namespace lapidary::app
