#include "description/nodes.h"
#include "description/object_node.h"

namespace lapidary::description {
namespace {

using geometry::Cone;
using geometry::Solid;
using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Unit;

constexpr auto section = "solids";

NodeKind cone() {
  Declaration<ObjectOf<Cone>> d(
      {.name = "cone", .doc = "A cone, or a cone cut off, with flat ends.", .section = section});
  d.parameter("from", &Cone::from, {.doc = "Middle of one end.", .unit = Unit::length})
      .parameter("to", &Cone::to, {.doc = "Middle of the other end.", .unit = Unit::length})
      .parameter("radius", &Cone::radius,
                 {.doc = "Radius at 'from'; 0 for a tip.",
                  .unit = Unit::length,
                  .range = schema::non_negative})
      .parameter("radius2", &Cone::radius2,
                 {.doc = "Radius at 'to'; 0 for a tip.",
                  .unit = Unit::length,
                  .range = schema::non_negative});
  return node_kind(declare_object(d), [](ObjectOf<Cone>&& c, const Context& context) {
    if (c.from == c.to) context.at("to").fail("must differ from 'from'");
    if (c.radius == 0.0 && c.radius2 == 0.0) {
      context.at("radius").fail("and 'radius2' must not both be 0");
    }
    return object_node(Solid(static_cast<const Cone&>(c)), std::move(c), context);
  });
}

}  // namespace

std::vector<NodeKind> curved_solid_kinds() {
  return {cone()};
}

}  // namespace lapidary::description
