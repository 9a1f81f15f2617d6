#pragma once

#include <stdexcept>
#include <string>

#include <fmt/core.h>

#include "csg_models.h"

/// Models as scenes of POV-Ray's language, to measure both programs on the same operands. Its frame
/// is left-handed: the picture is the mirror image, of the same cost.
namespace lapidary::bench {

/// A camera, a light and a floor, as the models of csg_models.h are looked at.
struct View {
  Vec3d from, at;
  double angle;  ///< horizontal, degrees
  double floor;  ///< height of the plane below
  Vec3d light;
};

inline std::string povray_vector(Vec3d v) {
  return fmt::format("<{:.17g}, {:.17g}, {:.17g}>", v.x, v.y, v.z);
}

inline std::string povray_solid(const Solid& solid) {
  if (const auto* s = std::get_if<geometry::Sphere>(&solid)) {
    return fmt::format("sphere {{ {}, {:.17g} }}", povray_vector(s->center), s->radius);
  }
  if (const auto* b = std::get_if<Box>(&solid)) {
    return fmt::format("box {{ {}, {} }}", povray_vector(b->min), povray_vector(b->max));
  }
  if (const auto* c = std::get_if<Cylinder>(&solid)) {
    return fmt::format("cylinder {{ {}, {}, {:.17g} }}", povray_vector(c->from),
                       povray_vector(c->to), c->radius);
  }
  throw std::invalid_argument("a solid that no model is made of");
}

/// A term that is no complement; an intersection of one operand with complements is a difference.
inline std::string povray_term(const Expression& expression, Term term) {
  if (term.is_leaf()) return povray_solid(expression.leaves()[term.index()].solid.shape());
  const Expression::Node& node = expression.nodes()[term.index()];
  const auto operands = expression.operands(node);
  const bool differs = operands.size() > 1 && operands[1].is_complement();
  std::string text = node.operation == Operation::unite ? "union" : "intersection";
  if (differs) text = "difference";
  text += " {\n";
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (operands[i].is_complement() != (differs && i > 0)) {
      throw std::invalid_argument("complements belong into differences");
    }
    const Term bare = operands[i].is_complement() ? ~operands[i] : operands[i];
    text += povray_term(expression, bare) + "\n";
  }
  return text + "}";
}

inline std::string povray_scene(const Expression& expression, Term term, const View& view) {
  return fmt::format(
      "#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n"
      "camera {{ perspective location {} look_at {} angle {} right x*4/3 }}\n"
      "light_source {{ {} color rgb 1 }}\n"
      "plane {{ y, {} pigment {{ color rgb 0.7 }} finish {{ ambient 0 diffuse 1 }} }}\n"
      "object {{\n{}\npigment {{ color rgb 0.5 }} finish {{ ambient 0 diffuse 1 }}\n}}\n",
      povray_vector(view.from), povray_vector(view.at), view.angle, povray_vector(view.light),
      view.floor, povray_term(expression, term));
}

}  // namespace lapidary::bench
