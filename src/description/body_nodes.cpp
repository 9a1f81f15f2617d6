#include <fmt/format.h>

#include "description/nodes.h"
#include "description/object_node.h"

namespace lapidary::description {
namespace {

using geometry::HalfSpace;
using geometry::Polyhedron;
using geometry::Solid;
using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Unit;
using schema::Value;

constexpr auto section = "solids";

// Preparing these takes time that grows with the square of their number.
constexpr std::size_t most_planes = 1000;
constexpr std::size_t most_vertices = 10000;

void check_count(std::size_t count, std::size_t most, const Context& context) {
  if (count > most) {
    context.fail(fmt::format("has {} entries; it takes {} at most", count, most),
                 "use a mesh for bodies of so many faces");
  }
}

/// {{point = ..., normal = ...}, ...}
struct PlaneListReader {
  static std::string type() { return "list of {point, normal}"; }
  static std::vector<HalfSpace> read(const Value& value, const Context& context) {
    if (value.kind() != schema::ValueKind::table || !value.table().fields.empty()) {
      fail_type("a list of planes {point = ..., normal = ...}", value, context);
    }
    static const Declaration<HalfSpace> plane =
        Declaration<HalfSpace>({.name = "a plane"})
            .parameter("point", &HalfSpace::point, {.unit = Unit::length})
            .parameter("normal", &HalfSpace::normal, {});
    std::vector<HalfSpace> planes;
    for (std::size_t i = 0; i < value.table().items.size(); ++i) {
      const Context at = context.at(i);
      planes.push_back(plane.read(value.table().items[i], at));
      if (planes.back().normal == Vec3d()) at.at("normal").fail("must not be zero");
    }
    return planes;
  }
  static std::string text(const std::vector<HalfSpace>&) { return ""; }
};

struct PolyhedronParameters {
  std::vector<HalfSpace> planes;
  std::vector<Vec3d> vertices;
};

Polyhedron to_polyhedron(const PolyhedronParameters& p, const Context& context) {
  if (p.planes.empty() == p.vertices.empty()) {
    context.fail("needs either 'planes' or 'vertices'");
  }
  if (!p.planes.empty()) {
    check_count(p.planes.size(), most_planes, context.at("planes"));
    if (auto found = geometry::intersection(p.planes)) return *found;
    context.at("planes").fail("leave nothing between them",
                              "each normal must point out of the solid");
  }
  check_count(p.vertices.size(), most_vertices, context.at("vertices"));
  try {
    return geometry::hull_of(p.vertices);
  } catch (const Error& error) {
    throw context.at("vertices").error(error.problem(), error.hint());
  }
}

NodeKind polyhedron() {
  using P = PolyhedronParameters;
  using Parameters = ObjectOf<P>;
  Declaration<Parameters> d({.name = "polyhedron",
                             .doc = "A convex body with flat faces, from its planes or corners.",
                             .section = section,
                             .examples = {"polyhedron { vertices = { { 0, 0, 0 }, { 1, 0, 0 }, "
                                          "{ 0, 1, 0 }, { 0, 0, 1 } } }",
                                          "polyhedron { planes = { { point = { 0, 0, 1 }, normal = "
                                          "{ 0, 0, 1 } } } }"}});
  d.parameter<PlaneListReader>("planes", &P::planes,
                               {.doc = "What they all have below them, as {point = {0, 0, 1}, "
                                       "normal = {0, 0, 1}}; may be unbounded."})
      .parameter("vertices", &P::vertices,
                 {.doc = "Corners {x, y, z} instead; those inside of the others do not matter.",
                  .unit = Unit::length});
  return node_kind(declare_object(d), [](Parameters&& p, const Context& context) {
    const std::size_t count = p.planes.size() + 2 * p.vertices.size();
    const Polyhedron made = to_polyhedron(p, context);
    schema::Node node = object_node(Solid(made), std::move(p), context);
    node.bytes += 512 * count;
    return node;
  });
}

/// Of a polygon, if it is not too many.
std::size_t count_points(const std::vector<Vec2d>& points,
                         const std::vector<std::vector<Vec2d>>& holes, const Context& context) {
  std::size_t count = points.size();
  for (const auto& hole : holes) count += hole.size();
  check_count(count, most_vertices, context.at("points"));
  return count;
}

struct PrismParameters {
  std::vector<Vec2d> points;
  std::vector<std::vector<Vec2d>> holes;
  double height = 1.0;
  double scale = 1.0;
};

NodeKind prism() {
  using P = PrismParameters;
  using Parameters = ObjectOf<P>;
  Declaration<Parameters> d({.name = "prism",
                             .doc = "A polygon in the plane z = 0, drawn out along z.",
                             .section = section,
                             .examples = {"prism { points = { { 0, 0 }, { 2, 0 }, { 1, 2 } }, "
                                          "height = 0.5 }"}});
  d.parameter("points", &P::points,
              {.doc = "The outline: corners {x, y}, in order either way round.",
               .unit = Unit::length,
               .need = schema::Need::required})
      .parameter(
          "holes", &P::holes,
          {.doc = "Lists of corners {x, y}, each a hole all the way up.", .unit = Unit::length})
      .parameter("height", &P::height,
                 {.doc = "How far it reaches up from z = 0.",
                  .unit = Unit::length,
                  .range = schema::positive})
      .parameter("scale", &P::scale,
                 {.doc = "Width of the top as a multiple of the bottom's, about the z axis; 0 for "
                         "a pyramid.",
                  .range = schema::non_negative});
  return node_kind(declare_object(d), [](Parameters&& p, const Context& context) {
    const std::size_t count = count_points(p.points, p.holes, context);
    try {
      const Solid made = geometry::make_prism({p.points, p.holes}, p.height, p.scale);
      schema::Node node = object_node(made, std::move(p), context);
      node.bytes += 512 * count;
      return node;
    } catch (const Error& error) {
      throw context.error(error.problem(), error.hint());
    }
  });
}

struct LatheParameters {
  std::vector<Vec2d> points;
  std::vector<std::vector<Vec2d>> holes;
  double angle = 360.0;
};

NodeKind lathe() {
  using P = LatheParameters;
  using Parameters = ObjectOf<P>;
  Declaration<Parameters> d(
      {.name = "lathe",
       .doc = "What a polygon sweeps as it turns about the z axis.",
       .section = section,
       .examples = {"lathe { points = { { 0, 0 }, { 1, 0 }, { 0.2, 0.4 }, { 0.5, 2 }, { 0, 2 } } }",
                    "lathe { points = { { 1, 0 }, { 2, 0 }, { 2, 0.5 } }, angle = 270 }"}});
  d.parameter("points", &P::points,
              {.doc = "The outline: corners {r, z}, distance from the axis and height, in order "
                      "either way round.",
               .unit = Unit::length,
               .need = schema::Need::required})
      .parameter("holes", &P::holes,
                 {.doc = "Lists of corners {r, z}, each a hollow all the way around.",
                  .unit = Unit::length})
      .parameter("angle", &P::angle,
                 {.doc = "How far it turns, counter-clockwise from the x axis; less than 360 ends "
                         "in flat faces.",
                  .unit = Unit::degrees,
                  .range = {0, 360, schema::Range::End::open}});
  return node_kind(declare_object(d), [](Parameters&& l, const Context& context) {
    const std::size_t count = count_points(l.points, l.holes, context);
    try {
      const Solid made = geometry::make_lathe({l.points, l.holes}, l.angle);
      schema::Node node = object_node(made, std::move(l), context);
      node.bytes += 256 * count;
      return node;
    } catch (const Error& error) {
      throw context.error(error.problem(), error.hint());
    }
  });
}

}  // namespace

std::vector<NodeKind> body_kinds() {
  return {polyhedron(), prism(), lathe()};
}

}  // namespace lapidary::description
