#include <fmt/format.h>

#include "description/nodes.h"
#include "description/object_node.h"

namespace lapidary::description {
namespace {

using geometry::Cylinder;
using geometry::HalfSpace;
using geometry::Solid;
using geometry::Sphere;
using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Unit;

constexpr auto section = "solids";

NodeKind sphere() {
  Declaration<ObjectOf<Sphere>> d({.name = "sphere",
                                   .doc = "A ball.",
                                   .section = section,
                                   .examples = {"sphere { center = { 0, 0, 1 }, radius = 1 }"}});
  d.parameter("center", &Sphere::center, {.doc = "Its centre.", .unit = Unit::length})
      .parameter("radius", &Sphere::radius,
                 {.doc = "Distance from the centre to the surface.",
                  .unit = Unit::length,
                  .range = schema::positive});
  return node_kind(declare_object(d), [](ObjectOf<Sphere>&& s, const Context& context) {
    return object_node(Solid(static_cast<const Sphere&>(s)), std::move(s), context);
  });
}

/// A box as people say it: by two corners, or by its size and where its middle is.
struct BoxParameters {
  std::optional<Vec3d> min, max, size, center;
};

geometry::Box to_box(const BoxParameters& b, const Context& context) {
  const bool corners = b.min || b.max, middle = b.size || b.center;
  if (corners == middle || (corners && !(b.min && b.max)) || (middle && !b.size)) {
    context.fail("needs either 'min' and 'max', or 'size' and perhaps 'center'");
  }
  geometry::Box box;
  if (corners) {
    box = {*b.min, *b.max};
  } else {
    const Vec3d center = b.center.value_or(Vec3d{}), half = *b.size * 0.5;
    box = {center - half, center + half};
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.min[axis] < box.max[axis]) continue;
    const Context part = context.at(corners ? "max" : "size");
    part.fail(fmt::format("leaves the box no extent along {}", "xyz"[axis]),
              corners ? "each of 'max' must be greater than that of 'min'"
                      : "the size is too small beside the centre's distance from 0");
  }
  return box;
}

NodeKind box() {
  using Parameters = ObjectOf<BoxParameters>;
  Declaration<Parameters> d({.name = "box",
                             .doc = "A box along the axes.",
                             .section = section,
                             .examples = {"box { size = { 2, 1, 0.5 } }",
                                          "box { min = { 0, 0, 0 }, max = { 2, 1, 0.5 } }"}});
  d.parameter(
       "size", &BoxParameters::size,
       {.doc = "Its extents along x, y and z.", .unit = Unit::length, .range = schema::positive})
      .parameter("center", &BoxParameters::center,
                 {.doc = "Its middle, with 'size'; {0, 0, 0} when left out.", .unit = Unit::length})
      .parameter("min", &BoxParameters::min,
                 {.doc = "Its lowest corner, with 'max'.", .unit = Unit::length})
      .parameter("max", &BoxParameters::max,
                 {.doc = "Its highest corner, with 'min'.", .unit = Unit::length});
  return node_kind(declare_object(d), [](Parameters&& b, const Context& context) {
    return object_node(Solid(to_box(b, context)), std::move(b), context);
  });
}

NodeKind half_space() {
  Declaration<ObjectOf<HalfSpace>> d(
      {.name = "half_space",
       .doc = "Everything on one side of a plane: the side the normal does not point to.",
       .section = section,
       .examples = {"half_space { point = { 0, 0, -1 } }"}});
  d.parameter("point", &HalfSpace::point, {.doc = "A point of the plane.", .unit = Unit::length})
      .parameter("normal", &HalfSpace::normal, {.doc = "Out of the solid; of any length."});
  return node_kind(declare_object(d), [](ObjectOf<HalfSpace>&& h, const Context& context) {
    if (length(h.normal) == 0.0) context.at("normal").fail("must not be zero");
    return object_node(Solid(static_cast<const HalfSpace&>(h)), std::move(h), context);
  });
}

NodeKind cylinder() {
  Declaration<ObjectOf<Cylinder>> d(
      {.name = "cylinder",
       .doc = "A round bar with flat ends.",
       .section = section,
       .examples = {"cylinder { from = { 0, 0, 0 }, to = { 0, 0, 2 }, radius = 0.4 }"}});
  d.parameter("from", &Cylinder::from, {.doc = "Middle of one end.", .unit = Unit::length})
      .parameter("to", &Cylinder::to, {.doc = "Middle of the other end.", .unit = Unit::length})
      .parameter("radius", &Cylinder::radius,
                 {.doc = "Distance from the axis to the side.",
                  .unit = Unit::length,
                  .range = schema::positive});
  return node_kind(declare_object(d), [](ObjectOf<Cylinder>&& c, const Context& context) {
    if (c.from == c.to) context.at("to").fail("must differ from 'from'");
    return object_node(Solid(static_cast<const Cylinder&>(c)), std::move(c), context);
  });
}

}  // namespace

std::vector<NodeKind> solid_kinds() {
  const NodeKind below = half_space();
  return {sphere(), box(), cylinder(), below,
          alias(below, "plane", "A floor without end, solid below: another name for half_space.",
                {"plane { material = matte \"#d8cfc0\" }"})};
}

}  // namespace lapidary::description
