#include "scene/combination_lights.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary::scene {
namespace {

using geometry::inherited_surface;
using geometry::SurfaceTag;

constexpr geometry::AreaPrecision of_power{0.001 / 3.0, std::size_t{1} << 22};
constexpr geometry::AreaPrecision for_choice{0.02, std::size_t{1} << 16};

geometry::SolidScene alone(geometry::Expression expression, geometry::Expression::Term root) {
  geometry::Region region;
  region.root = root;
  region.medium = 1;  // something else than the surroundings
  geometry::SolidScene::Parts parts;
  parts.expression = std::move(expression);
  parts.regions.push_back(region);
  return geometry::SolidScene(std::move(parts));
}

geometry::SeenSides sides_of(const geometry::BooleanTree& tree, std::uint32_t leaf) {
  geometry::SeenSides sides;
  for (const auto link : tree.leaf_links(leaf)) {
    (link.is_complement() ? sides.inside : sides.outside) = true;
  }
  return sides;
}

/// Whether a surface in it can have an area.
bool has_room(const Box3d& box) {
  if (box.empty()) return false;
  const Vec3d e = box.extent();
  return e.x * e.y > 0.0 || e.y * e.z > 0.0 || e.z * e.x > 0.0;
}

}  // namespace

struct CombinationLights::Body {
  explicit Body(geometry::ExpressionPart part)
      : leaf_numbers(std::move(part.leaf_numbers)),
        region(alone(std::move(part.expression), part.root)) {
    std::vector<Box3d> bounds;
    for (const auto& leaf : leaves()) bounds.push_back(geometry::bounds(leaf.solid));
    boxes = geometry::clipped_bounds(tree(), std::move(bounds)).leaves;
    for (const auto& leaf : leaves()) own_tags.insert(leaf.tag);
    own_tags.erase(inherited_surface);
  }

  const std::vector<geometry::Compound::Leaf>& leaves() const { return region.world().leaves(); }
  const geometry::BooleanTree& tree() const { return region.world().tree(); }

  std::vector<std::uint32_t> leaf_numbers;  ///< in the compound that the region stands in
  geometry::SolidScene region;
  std::vector<Box3d> boxes;  ///< of leaves, clipped
  std::set<SurfaceTag> own_tags;
  std::map<Wearers, Surface> surfaces;
};

CombinationLights::CombinationLights(const Solids& solids, const Tools& tools)
    : solids_(solids), tools_(tools) {
  for (const SolidSlot& slot : solids.slots) {
    if (emission_of(*slot.material) == nullptr) continue;
    if (glowing_objects_.size() <= slot.object) glowing_objects_.resize(slot.object + 1);
    glowing_objects_[slot.object] = true;
  }
}

const description::Emission* CombinationLights::emission(SurfaceTag tag) const {
  return emission_of(*solids_.slots[tag].material);
}

/// What leaves of assemblies wear counts as that of their first instance.
bool CombinationLights::may_glow(const SolidRegion& region) const {
  if (glowing_objects_.empty()) return false;
  if (region.region.instance != geometry::Region::no_instance) return true;
  return region.object < glowing_objects_.size() && glowing_objects_[region.object];
}

std::shared_ptr<CombinationLights::Body> CombinationLights::body_of(const SolidRegion& region) {
  if (region.region.instance == geometry::Region::no_instance) {
    return std::make_shared<Body>(geometry::part_of(solids_.expression, region.region.root));
  }
  const std::uint32_t number = solids_.instances[region.region.instance].assembly;
  std::shared_ptr<Body>& known = assemblies_[number];
  if (!known) {
    const geometry::Assembly& assembly = solids_.assemblies[number];
    known = std::make_shared<Body>(geometry::part_of(assembly.expression, assembly.root));
  }
  return known;
}

std::vector<SurfaceTag> CombinationLights::glowing_tags(const SolidRegion& region,
                                                        const Body& body) const {
  std::set<SurfaceTag> tags = body.own_tags;
  tags.insert(region.region.tag);
  std::erase_if(tags, [this](SurfaceTag tag) { return emission(tag) == nullptr; });
  return {tags.begin(), tags.end()};
}

std::vector<CombinationLights::Found> CombinationLights::of(const SolidRegion& region,
                                                            std::uint32_t place) {
  std::vector<Found> found;
  if (!may_glow(region)) return found;
  const std::shared_ptr<Body> body = body_of(region);
  for (const SurfaceTag tag : glowing_tags(region, *body)) {
    if (auto light = light_of(region, place, *body, tag)) found.push_back({tag, std::move(*light)});
  }
  return found;
}

CombinationLights::Surface& CombinationLights::surface_of(Body& body, const Wearers& wearers,
                                                          const SolidRegion& region) {
  const auto [found, is_new] = body.surfaces.try_emplace(wearers);
  Surface& surface = found->second;
  if (!is_new) return surface;
  std::vector<geometry::CompoundSurface::Piece> pieces;
  for (std::uint32_t i = 0; i < body.leaves().size(); ++i) {
    const geometry::Compound::Leaf& leaf = body.leaves()[i];
    const bool inherits = leaf.tag == inherited_surface;
    if (inherits ? !wearers.inherit : leaf.tag != wearers.own) continue;
    const Box3d& box = body.boxes[i];
    if (!has_room(box)) continue;
    if (!box.bounded()) {
      throw Error(region.where.location(), "nothing bounds the surface that is to give light here",
                  "intersect the solid with a box that says how far it reaches");
    }
    const geometry::SeenSides sides = sides_of(body.tree(), i);
    const auto add = [&](std::uint32_t stated) {
      pieces.push_back({body.leaf_numbers[stated],
                        geometry::LeafSurface(body.leaves()[stated].solid, box, sides)});
    };
    // Hits name leaves as they were stated, so what is fused is drawn from piece by piece.
    const auto parts = body.region.world().parts(i);
    if (parts.empty()) add(i);
    for (const std::uint32_t part : parts) add(part);
  }
  std::sort(pieces.begin(), pieces.end(),
            [](const auto& a, const auto& b) { return a.leaf < b.leaf; });
  if (!pieces.empty()) {
    surface.leaves = std::make_shared<const geometry::CompoundSurface>(std::move(pieces));
  }
  return surface;
}

geometry::AreaEstimate CombinationLights::area_of(const Body& body, Surface& surface,
                                                  const Transform& map,
                                                  description::Quantity quantity) {
  const bool is_power = quantity == description::Quantity::power;
  const geometry::AreaPrecision& precision = is_power ? of_power : for_choice;
  const geometry::WornSurface worn{body.region, *surface.leaves, body.leaf_numbers};
  const auto scale = map.similarity();
  if (!scale) return geometry::worn_area(worn, map.linear(), precision, tools_.pool);
  // All copies of one size share the work.
  std::optional<geometry::AreaEstimate>& known = is_power ? surface.precise : surface.rough;
  if (!known) known = geometry::worn_area(worn, Mat3::identity(), precision, tools_.pool);
  const double grows = *scale * *scale;
  return {known->area * grows, known->standard_error * grows};
}

void CombinationLights::warn_of(const geometry::AreaEstimate& area, description::Quantity quantity,
                                const SolidRegion& region) {
  if (!(area.area > 0.0)) {
    tools_.warnings.add(
        region.where.location(),
        "what should give light here has no surface to speak of: it is cut away, or "
        "inside of something else");
    return;
  }
  const double error = 3.0 * area.standard_error / area.area;
  constexpr double told = 3.0 * of_power.relative_error;
  if (quantity != description::Quantity::power || error <= told) return;
  tools_.warnings.add(
      region.where.location(),
      fmt::format("the glowing surface is a small rest of what it is cut from: the power of this "
                  "light is right to {:.2g} % only",
                  100.0 * error));
}

std::optional<light::Light> CombinationLights::light_of(const SolidRegion& region,
                                                        std::uint32_t place, Body& body,
                                                        SurfaceTag tag) {
  Wearers wearers{tag == region.region.tag, inherited_surface};
  if (body.own_tags.count(tag) != 0) wearers.own = tag;
  Surface& surface = surface_of(body, wearers, region);
  light::CombinationLight::Place stands{place};
  Transform map;
  if (region.region.instance != geometry::Region::no_instance) {
    const geometry::Instance& instance = solids_.instances[region.region.instance];
    map = instance.world_from_assembly;
    stands.own = geometry::OwnSpace(map);
    stands.motion = instance.motion;
  }
  const description::Emission& emitted = *emission(tag);
  geometry::AreaEstimate area;
  if (surface.leaves) area = area_of(body, surface, map, emitted.quantity);
  warn_of(area, emitted.quantity, region);
  if (!surface.leaves) return std::nullopt;
  return tools_.lights.combination(surface.leaves, stands, area.area, emitted);
}

}  // namespace lapidary::scene
