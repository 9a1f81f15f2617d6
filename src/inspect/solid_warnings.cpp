#include "inspect/solid_warnings.h"

#include <algorithm>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "description/leaves.h"
#include "geometry/sweep.h"
#include "inspect/lone_body.h"
#include "inspect/naming.h"
#include "inspect/operands.h"
#include "sampling/sobol.h"
#include "sampling/warp.h"

namespace lapidary::inspect {
namespace {

using description::Leaf;
using geometry::SolidScene;

std::string described(const Leaf& leaf) {
  const std::string kind = kind_of(leaf.object);
  return leaf.name.empty() ? kind : fmt::format("{} '{}'", kind, leaf.name);
}

std::vector<bool> combined_objects(const description::SceneDescription& scene) {
  std::vector<bool> combined;
  description::for_each_leaf(scene.objects,
                             [&](const Leaf& leaf) { combined.push_back(is_combined(leaf)); });
  return combined;
}

/// Whether one of a few lines through the bounds of a region comes through it. Other regions may
/// hide it.
bool shows(const SolidScene& solids, std::uint32_t region) {
  constexpr std::uint64_t seed = 1868;
  constexpr std::uint32_t lines = 16;
  const Box3d box = solids.bounds(region);
  if (!box.bounded()) return false;
  const Vec3d extent = box.extent();
  for (std::uint32_t i = 0; i < lines; ++i) {
    const Block8 u = PixelSampler(seed, region, 0, i).block(0);
    const Vec3d direction = sample_uniform_sphere({u[0], u[1]});
    const Vec3d p = box.min + Vec3d{u[2] * extent.x, u[3] * extent.y, u[4] * extent.z};
    const geometry::Ray ray{p, direction};
    geometry::Sweep sweep(solids, ray, 1.01 * length(extent));
    geometry::Transition found;
    while (sweep.next(found)) {
      if (found.before == region || found.after == region) return true;
    }
    if (sweep.region() == region) return true;
  }
  return false;
}

}  // namespace

void warn_about_empty_solids(const description::SceneDescription& scene, const scene::Scene& built,
                             WarningLog& warnings) {
  // What a few lines through the finished scene meet need not be built again by itself.
  std::vector<bool> suspect = combined_objects(scene);
  const SolidScene& solids = built.world().solids();
  for (std::uint32_t region = 0; region < solids.region_count(); ++region) {
    const std::uint32_t object = built.region_filling(region).object;
    if (suspect[object] && shows(solids, region)) suspect[object] = false;
  }
  std::vector<Location> told;
  std::size_t index = 0;
  description::for_each_leaf(scene.objects, [&](const Leaf& leaf) {
    if (!suspect[index++]) return;
    const Location where = leaf.object.where.location();
    const bool known = where.line > 0 && std::ranges::count(told, where) > 0;
    if (known || !seems_empty(lone_body(leaf))) return;
    told.push_back(where);
    warnings.add(
        where, fmt::format("nothing is left of the {}: no line through what it is made of meets it",
                           described(leaf)));
  });
}

void warn_about_buried_camera(const description::SceneDescription& scene, const scene::Scene& built,
                              WarningLog& warnings) {
  const description::Camera& camera = scene.camera.value();
  const Vec3d from = std::visit([](const auto& model) { return model.view.from; }, camera.model);
  const SolidScene& solids = built.world().solids();
  if (solids.region_count() == 0) return;
  const std::uint32_t region = geometry::region_at(solids, from);
  if (region == SolidScene::no_region) return;
  if (solids.region(region).opacity != geometry::Opacity::opaque) return;
  std::string solid;
  std::size_t index = 0;
  description::for_each_leaf(scene.objects, [&](const Leaf& leaf) {
    if (index++ == built.region_filling(region).object) solid = described(leaf);
  });
  warnings.add(
      camera.where.location(),
      fmt::format("the camera stands inside of the {}, which is opaque; a room to stand in "
                  "is ~box {{...}} or a difference",
                  solid));
}

}  // namespace lapidary::inspect
