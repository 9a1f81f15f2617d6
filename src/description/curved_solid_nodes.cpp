#include "description/nodes.h"
#include "description/object_node.h"

namespace lapidary::description {
namespace {

using geometry::Cone;
using geometry::Solid;
using geometry::Torus;
using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Unit;

constexpr auto section = "solids";

NodeKind cone() {
  Declaration<ObjectOf<Cone>> d(
      {.name = "cone",
       .doc = "A cone, or a cone cut off, with flat ends.",
       .section = section,
       .examples = {"cone { from = { 0, 0, 0 }, to = { 0, 0, 2 }, radius = 1 }",
                    "cone { to = { 0, 0, 2 }, radius = 1, radius2 = 0.5 }"}});
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

NodeKind torus() {
  Declaration<ObjectOf<Torus>> d({.name = "torus",
                                  .doc = "A ring: what a disk sweeps around an axis.",
                                  .section = section,
                                  .examples = {"torus { major_radius = 1, minor_radius = 0.2 }"}});
  d.parameter("center", &Torus::center, {.doc = "The middle of the ring.", .unit = Unit::length})
      .parameter("axis", &Torus::axis, {.doc = "What it goes around; of any length."})
      .parameter("major_radius", &Torus::major_radius,
                 {.doc = "Distance from the axis to the disk's centre.",
                  .unit = Unit::length,
                  .range = schema::positive})
      .parameter("minor_radius", &Torus::minor_radius,
                 {.doc = "Radius of the disk; beyond 'major_radius' the hole is closed.",
                  .unit = Unit::length,
                  .range = schema::positive});
  return node_kind(declare_object(d), [](ObjectOf<Torus>&& t, const Context& context) {
    if (length(t.axis) == 0.0) context.at("axis").fail("must not be zero");
    t.axis = normalize(t.axis);
    return object_node(Solid(static_cast<const Torus&>(t)), std::move(t), context);
  });
}

/// A ball of its own under a placement of its own.
struct EllipsoidParameters {
  Vec3d center;
  Vec3d radii{1, 0.75, 0.5};
};

NodeKind ellipsoid() {
  using Parameters = ObjectOf<EllipsoidParameters>;
  Declaration<Parameters> d(
      {.name = "ellipsoid",
       .doc = "A ball stretched along the axes.",
       .section = section,
       .examples = {"ellipsoid { center = { 0, 0, 1 }, radii = { 2, 1, 1 } }"}});
  d.parameter("center", &EllipsoidParameters::center, {.doc = "Its centre.", .unit = Unit::length})
      .parameter("radii", &EllipsoidParameters::radii,
                 {.doc = "Its half extents along x, y and z.",
                  .unit = Unit::length,
                  .range = schema::positive});
  return node_kind(declare_object(d), [](Parameters&& e, const Context& context) {
    auto placement = std::make_shared<const Transform>(Transform::translation(e.center) *
                                                       Transform::scaling(e.radii));
    return object_node(Solid(geometry::Sphere{}), std::move(e), context, std::move(placement));
  });
}

NodeKind quadric() {
  using Parameters = ObjectOf<geometry::QuadraticForm>;
  using geometry::QuadraticForm;
  Declaration<Parameters> d({.name = "quadric",
                             .doc = "Where a polynomial of the second degree is at most 0.",
                             .section = section,
                             .examples = {"quadric { squares = { 1, 1, 0 }, linear = { z = -1 }, "
                                          "constant = 0 }"}});
  d.parameter("squares", &QuadraticForm::squares, {.doc = "Coefficients of x^2, y^2 and z^2."})
      .parameter("products", &QuadraticForm::products, {.doc = "Coefficients of xy, xz and yz."})
      .parameter("linear", &QuadraticForm::linear, {.doc = "Coefficients of x, y and z."})
      .parameter("constant", &QuadraticForm::constant, {.doc = "What is added to these."});
  return node_kind(declare_object(d), [](Parameters&& q, const Context& context) {
    if (q.squares == Vec3d{} && q.products == Vec3d{} && q.linear == Vec3d{}) {
      context.at("squares").fail("must not be zero when 'products' and 'linear' are");
    }
    auto form = std::make_shared<const QuadraticForm>(static_cast<const QuadraticForm&>(q));
    return object_node(Solid(geometry::Quadric{std::move(form)}), std::move(q), context);
  });
}

/// Beyond 2 the formula has dents.
void check_exponent(double exponent, const Context& at) {
  if (exponent <= 2.0) return;
  at.fail("must be at most 2: beyond, the solid is not convex and cannot be met exactly");
}

NodeKind superellipsoid() {
  using geometry::Superellipsoid;
  Declaration<ObjectOf<Superellipsoid>> d(
      {.name = "superellipsoid",
       .doc = "Between ball, box, cylinder and octahedron: where (|x|^(2/e) + |y|^(2/e))^(e/n) + "
              "|z|^(2/n) is at most 1, in units of 'radii' about 'center'.",
       .section = section,
       .examples = {"superellipsoid { radii = { 1, 1, 0.5 }, e = 0.2, n = 0.2 }",
                    "superellipsoid { e = 1, n = 2 }"}});
  d.parameter("center", &Superellipsoid::center, {.doc = "Its centre.", .unit = Unit::length})
      .parameter("radii", &Superellipsoid::radii,
                 {.doc = "Its half extents along x, y and z.",
                  .unit = Unit::length,
                  .range = schema::positive})
      .parameter("e", &Superellipsoid::e,
                 {.doc = "Shape across z, at most 2: near 0 square, 1 round, 2 a rhomb.",
                  .range = schema::positive})
      .parameter("n", &Superellipsoid::n,
                 {.doc = "The same along z: near 0 with flat ends, 1 round, 2 pointed.",
                  .range = schema::positive});
  return node_kind(declare_object(d), [](ObjectOf<Superellipsoid>&& s, const Context& context) {
    check_exponent(s.e, context.at("e"));
    check_exponent(s.n, context.at("n"));
    return object_node(Solid(static_cast<const Superellipsoid&>(s)), std::move(s), context);
  });
}

}  // namespace

std::vector<NodeKind> curved_solid_kinds() {
  return {cone(), torus(), ellipsoid(), superellipsoid(), quadric()};
}

}  // namespace lapidary::description
