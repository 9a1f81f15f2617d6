#include "description/solids.h"

#include <algorithm>

#include "description/fold.h"
#include "geometry/placed_solid.h"

namespace lapidary::description {
namespace {

Box3d leaf_bounds(const Object& object) {
  const Transform& placement = object.parent_from_object();
  if (const auto* solid = std::get_if<geometry::Solid>(&object.content)) {
    return geometry::bounds(geometry::PlacedSolid(*solid, placement));
  }
  if (const auto* mesh = std::get_if<Mesh>(&object.content)) {
    return placement.box(geometry::bounds(*mesh->triangles));
  }
  return {};
}

Box3d joined_bounds(const Object& object, std::span<const Box3d> parts) {
  const Combination* combination = object.combination();
  Box3d box;
  switch (combination ? combination->operation() : SetOperation::unite) {
    case SetOperation::unite:
      for (const Box3d& part : parts) box.extend(part);
      break;
    case SetOperation::intersect:
      box = Box3d::all();
      for (const Box3d& part : parts) box = box.intersect(part);
      break;
    case SetOperation::subtract:
    case SetOperation::section:
      box = parts.front();
      break;
    case SetOperation::complement:
      box = Box3d::all();
      break;
  }
  return object.parent_from_object().box(box);
}

}  // namespace

std::size_t operand_count(const Object& object) {
  if (std::holds_alternative<Mesh>(object.content)) return 0;
  const auto of_leaf = [](const Object& leaf) -> std::size_t {
    return std::holds_alternative<geometry::Sheet>(leaf.content) ? 0 : 1;
  };
  return fold<std::size_t>(object, of_leaf, [](const Object&, std::span<const std::size_t> parts) {
    std::size_t sum = 0;
    for (const std::size_t part : parts) sum = std::min(sum + part, operand_count_limit);
    return sum;
  });
}

Box3d bounds(const Combination& combination) {
  return fold<Box3d>(Object{combination, nullptr, nullptr, nullptr, {}}, leaf_bounds, joined_bounds,
                     inner_parts_of);
}

}  // namespace lapidary::description
