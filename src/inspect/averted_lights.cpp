#include "inspect/averted_lights.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "description/leaves.h"
#include "description/solids.h"
#include "geometry/placed_solid.h"
#include "geometry/sheet.h"
#include "geometry/triangle_mesh.h"
#include "inspect/worn.h"

namespace lapidary::inspect {
namespace {

using description::Leaf;

/// A flat light: its front is where dot(normal, p - point) > 0.
struct Panel {
  Location where;
  std::string name;
  Vec3d point;
  Vec3d normal;  ///< unit length
};

std::vector<Panel> panels_of(const description::SceneDescription& scene) {
  std::vector<Panel> panels;
  description::for_each_leaf(scene.objects, [&panels](const Leaf& leaf) {
    const auto* sheet = std::get_if<geometry::Sheet>(&leaf.object.content);
    if (sheet == nullptr || worn_by(leaf).glow == Glow::none) return;
    const geometry::Sheet placed = geometry::transformed(*sheet, leaf.world_from_object);
    panels.push_back({leaf.object.where.location(), std::string(leaf.name),
                      geometry::bounds(placed).center(), geometry::front_normal(placed)});
  });
  return panels;
}

Box3d bounds_of(const Leaf& leaf) {
  if (const auto* solid = std::get_if<geometry::Solid>(&leaf.object.content)) {
    return bounds(geometry::PlacedSolid(*solid, leaf.world_from_object));
  }
  if (const auto* sheet = std::get_if<geometry::Sheet>(&leaf.object.content)) {
    return leaf.world_from_object.box(geometry::bounds(*sheet));
  }
  if (const auto* combination = leaf.object.combination()) {
    return leaf.world_from_object.box(description::bounds(*combination));
  }
  const auto& mesh = std::get<description::Mesh>(leaf.object.content);
  return leaf.world_from_object.box(geometry::bounds(*mesh.triangles));
}

/// Whether more of `box` than rounding moves lies before the panel.
bool reaches_before(const Box3d& box, const Panel& panel) {
  constexpr double relative_rounding = 1e-9;
  const Vec3d half = box.extent() * 0.5;
  const double height =
      dot(panel.normal, box.center() - panel.point) + dot(abs(panel.normal), half);
  const Vec3d reach = max(abs(box.min), abs(box.max)) + abs(panel.point);
  return height > relative_rounding * max_component(reach);
}

std::string warning_about(const Panel& panel) {
  return fmt::format(
      "the light{} faces away from every object, and its back is black; turn it with 'normal' or "
      "'at', or swap its edges",
      panel.name.empty() ? "" : fmt::format(" '{}'", panel.name));
}

}  // namespace

void warn_about_averted_lights(const description::SceneDescription& scene, WarningLog& warnings) {
  std::vector<Panel> averted = panels_of(scene);
  bool any_object = false;
  description::for_each_leaf(scene.objects, [&](const Leaf& leaf) {
    // Most panels have something before them, so the search mostly ends here.
    if (averted.empty() || worn_by(leaf).glow == Glow::whole) return;
    const Box3d box = bounds_of(leaf);
    if (!box.bounded()) return;
    any_object = true;
    std::erase_if(averted, [&box](const Panel& panel) { return reaches_before(box, panel); });
  });
  if (!any_object) return;
  std::vector<Location> told;
  for (const Panel& panel : averted) {
    const bool known = panel.where.line > 0 && std::ranges::count(told, panel.where) > 0;
    if (known) continue;
    told.push_back(panel.where);
    warnings.add(panel.where, warning_about(panel));
  }
}

}  // namespace lapidary::inspect
