#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

#include <fmt/core.h>

#include "app/commands.h"
#include "app/load_scene.h"
#include "app/messages.h"
#include "inspect/averted_lights.h"
#include "inspect/report.h"
#include "inspect/solid_warnings.h"
#include "scene/build.h"

namespace lapidary::app {
namespace {

using inspect::Glow;
using inspect::ObjectReport;
using inspect::SceneReport;

/// Longer lists are cut: a scene may have a million objects.
constexpr std::size_t longest_list = 50;

std::string number_or(const std::optional<double>& value, const char* otherwise) {
  return value ? fmt::format("{:.6g}", *value) : otherwise;
}

/// "1 object", "2 objects".
std::string counted(std::size_t count, std::string_view thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

/// "name (scene.lua:7)", as far as known.
std::string placed(const std::string& name, const Location& where) {
  return where.file.empty() ? name : fmt::format("{} ({})", name, to_string(where));
}

std::string label(const ObjectReport& object) {
  return placed(object.name.empty() ? object.kind : fmt::format("'{}'", object.name), object.where);
}

/// Whether it has an inside, and of a mesh that has none, how many edges have one neighbour only.
std::string closed_text(const ObjectReport& object) {
  if (object.closed) return "yes";
  const bool open_mesh = object.closure && object.closure->open_edges > 0;
  return open_mesh ? fmt::format("{} open", object.closure->open_edges) : "no";
}

std::string estimate_text(const inspect::Estimate& estimate) {
  return fmt::format("{:.5g} ±{:.1g}", estimate.value, estimate.standard_error);
}

constexpr const char* unmeasured = "not measured";

std::string area_text(const ObjectReport& object) {
  if (object.combined && !object.combination) return unmeasured;
  if (!object.combination) return number_or(object.measure.area, "infinite");
  const auto& size = object.combination->size;
  return size ? estimate_text(size->area) : "unbounded";
}

std::string volume_text(const ObjectReport& object) {
  if (object.combined && !object.combination) return unmeasured;
  if (!object.combination) {
    return number_or(object.measure.volume, object.closed ? "infinite" : "-");
  }
  const auto& size = object.combination->size;
  return size ? estimate_text(size->volume) : "unbounded";
}

void print_more(std::size_t total) {
  if (total > longest_list) fmt::print("  and {} more\n", total - longest_list);
}

void print_objects(const SceneReport& report) {
  if (report.objects == 0) return;
  fmt::print("\n  {:<16}{:>10}  {:<12}{:>17}  {:>17}  {}\n", "kind", "triangles", "closed", "area",
             "volume", "object");
  std::size_t count = 0;
  for (const ObjectReport& object : report.surfaces) {
    if (object.worn.glow == Glow::whole || ++count > longest_list) continue;
    fmt::print("  {:<16}{:>10}  {:<12}{:>17}  {:>17}  {}\n", object.kind, object.triangles,
               closed_text(object), area_text(object), volume_text(object), label(object));
  }
  print_more(count);
}

std::string corner(Vec3d p) {
  // Boxes are rounded outward: a zero to the least number there is.
  const auto shown = [](double x) { return std::abs(x) < 1e-300 ? 0.0 : x; };
  return fmt::format("{{{:.4g}, {:.4g}, {:.4g}}}", shown(p.x), shown(p.y), shown(p.z));
}

/// The axes along which a box does not end: "+x, -z".
std::string open_ends(const Box3d& box) {
  std::string list;
  const auto add = [&](double end, char sign, std::size_t axis) {
    if (!std::isfinite(end))
      list += fmt::format("{}{}{}", list.empty() ? "" : ", ", sign, "xyz"[axis]);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    add(box.max[axis], '+', axis);
    add(box.min[axis], '-', axis);
  }
  return list;
}

/// What a combination comes to.
std::string extent_text(const inspect::CombinationReport& combination) {
  const Box3d& box = combination.bounds;
  if (combination.operands.empty) return "nothing is left of it";
  if (!box.bounded()) {
    return fmt::format(
        "unbounded: nothing in it ends it towards {}, so that it is neither measured nor framed",
        open_ends(box));
  }
  return fmt::format("from {} to {}", corner(box.min), corner(box.max));
}

void print_idle(const inspect::OperandReport& operands) {
  constexpr std::size_t most = 10;
  std::string list;
  for (std::size_t i = 0; i < std::min(operands.idle.size(), most); ++i) {
    list += fmt::format("{}{} ({})", i == 0 ? "" : ", ", operands.idle[i].number,
                        operands.idle[i].kind);
  }
  if (operands.idle.size() > most) list += fmt::format(" and {} more", operands.idle.size() - most);
  const std::string part = operands.examined < operands.live
                               ? fmt::format(", looked for in {} of them", operands.examined)
                               : "";
  fmt::print("    operands that add no surface, by {} lines each{}: {}\n", operands.lines, part,
             list);
}

/// Where a model is so small, so far from the origin, that doubles hardly tell its surfaces apart.
void print_cut_lines(const inspect::OperandReport& operands) {
  fmt::print(
      "    rounding is as coarse as the model here: along {} of {} surfaces could not be told "
      "apart; "
      "build it nearer to the origin\n",
      operands.cut_lines, counted(operands.lines_followed, "line"));
}

void print_combinations(const SceneReport& report) {
  std::size_t count = 0;
  for (const ObjectReport& object : report.surfaces) {
    if (!object.combination || ++count > longest_list) continue;
    if (count == 1) fmt::print("\n  combined solids, measured by random lines:\n");
    const inspect::OperandReport& operands = object.combination->operands;
    const auto& size = object.combination->size;
    fmt::print("  {}: {}, {} of them clipped away; {}{}\n", label(object),
               counted(operands.stated, "operand"), operands.stated - operands.live,
               extent_text(*object.combination),
               size ? fmt::format("; {}", counted(size->lines, "line")) : "");
    if (!operands.idle.empty() && !operands.empty) print_idle(operands);
    if (operands.cut_lines > 0) print_cut_lines(operands);
  }
  print_more(count);
  if (report.unmeasured > 0) {
    fmt::print("  {} too many to be measured\n", counted(report.unmeasured, "more combination"));
  }
}

void print_lights(const SceneReport& report) {
  if (report.lights == 0) return;
  fmt::print("\n  {:<16}{:>11}  {}\n", "kind", "area", "light");
  std::size_t count = 0;
  for (const ObjectReport& light : report.surfaces) {
    if (light.worn.glow == Glow::none || ++count > longest_list) continue;
    const bool whole = light.worn.glow == Glow::whole;
    fmt::print("  {:<16}{:>11}  {}\n", light.kind,
               whole ? number_or(light.measure.area, "infinite") : "a part", label(light));
  }
  for (const inspect::LightReport& light : report.lights_without_surface) {
    if (++count > longest_list) continue;
    fmt::print("  {:<16}{:>11}  {}\n", light.kind, "-", placed(light.kind, light.where));
  }
  print_more(count);
}

/// Joins what is not empty.
std::string joined(std::initializer_list<std::string> parts) {
  std::string text;
  for (const std::string& part : parts) {
    text += (text.empty() || part.empty() ? "" : "; ") + part;
  }
  return text;
}

/// What is wrong with the edges of a mesh, or empty. Being open is wrong for glass alone: other
/// meshes may well be sheets.
std::string edge_problem(const geometry::MeshClosure& closure, bool is_glass) {
  const bool lacks_inside = is_glass && closure.open_edges > 0;
  std::string problem =
      joined({lacks_inside
                  ? fmt::format("made of glass, but not closed: {} open edges", closure.open_edges)
                  : "",
              closure.misoriented_edges > 0
                  ? fmt::format("{} wrongly turned edges", closure.misoriented_edges)
                  : ""});
  const bool example_is_one = lacks_inside || closure.open_edges == 0;
  if (!problem.empty() && example_is_one && closure.example) {
    const Vec3d p = *closure.example;
    problem += fmt::format(", one near {:.4g}, {:.4g}, {:.4g} of the mesh", p.x, p.y, p.z);
  }
  return problem;
}

/// What is wrong with the surface of a mesh, or empty.
std::string mesh_problem(const ObjectReport& object) {
  if (!object.closure) return "";
  const geometry::MeshClosure& closure = *object.closure;
  const bool inside_out = closure.closed() && object.measure.volume.value_or(0) < 0;
  return joined({edge_problem(closure, object.worn.glass),
                 inside_out ? "inside out: its triangles are clockwise seen from outside" : "",
                 closure.degenerate_triangles > 0
                     ? fmt::format("{} triangles without area", closure.degenerate_triangles)
                     : ""});
}

void print_mesh_problems(const SceneReport& report) {
  std::size_t count = 0;
  for (const ObjectReport& object : report.surfaces) {
    const std::string problem = mesh_problem(object);
    if (problem.empty()) continue;
    if (count == 0) fmt::print("\nmeshes to look at:\n");
    if (++count <= longest_list) fmt::print("  {}: {}\n", label(object), problem);
  }
  print_more(count);
}

void print_overlaps(const SceneReport& report) {
  const auto& [overlaps, complete] = report.overlaps;
  if (!overlaps.empty()) fmt::print("\nopaque objects that share a part of their insides:\n");
  for (std::size_t i = 0; i < std::min(overlaps.size(), longest_list); ++i) {
    fmt::print("  {} and {}\n", label(report.surfaces[overlaps[i].first]),
               label(report.surfaces[overlaps[i].second]));
  }
  print_more(overlaps.size());
  if (!complete) fmt::print("  there are too many pairs to look at all of them\n");
}

}  // namespace

ExitCode run(const CheckCommand& command) {
  ThreadPool pool;
  WarningLog warnings;
  auto description = load_scene(command.scene, {}, {warnings});
  const SceneReport report = inspect::inspect(description, pool);
  fmt::print("{}: {}, {}, {}, {}\n", command.scene.file, counted(report.objects, "object"),
             counted(report.operands, "operand"), counted(report.triangles, "triangle"),
             counted(report.lights, "light"));
  print_objects(report);
  print_combinations(report);
  print_lights(report);
  print_mesh_problems(report);
  print_overlaps(report);
  std::fflush(stdout);
  // What a renderer would refuse, building the scene refuses.
  complete_scene(command.scene, description);
  inspect::warn_about_averted_lights(description, warnings);
  const scene::Scene scene = scene::build(description, {description.render.size, pool, warnings});
  inspect::warn_about_empty_solids(description, scene, warnings);
  inspect::warn_about_buried_camera(description, scene, warnings);
  print_warnings(warnings.take());
  return ExitCode::done;
}

}  // namespace lapidary::app
