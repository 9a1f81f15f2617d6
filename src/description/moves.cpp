#include "description/moves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "math/constants.h"
#include "schema/declaration.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Reader;
using schema::Value;
using schema::ValueKind;

bool has_field(const Value& value, std::string_view key) {
  if (value.kind() != ValueKind::table) return false;
  const auto fields = value.table().fields;
  return std::any_of(fields.begin(), fields.end(),
                     [key](const schema::Field& field) { return field.key == key; });
}

/// About a coordinate axis, exact for quarter turns.
Transform turn(std::size_t axis, double angle) {
  const double quarters = angle / 90.0;
  if (quarters != std::floor(quarters)) {
    Vec3d direction;
    direction[axis] = 1.0;
    return Transform::rotation(direction, radians(angle));
  }
  constexpr std::array<int, 4> cosines{1, 0, -1, 0};
  const auto quarter = static_cast<std::size_t>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0));
  const double c = cosines[quarter], s = cosines[(quarter + 3) % 4];
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  Mat3 m;
  m.row[i][i] = c, m.row[i][j] = -s;
  m.row[j][i] = s, m.row[j][j] = c;
  return *Transform::affine(m, {});
}

Transform read_rotation(const Value& value, const Context& context) {
  if (const auto turned = read_axis_angle(value, context)) {
    return Transform::rotation(turned->axis, turned->angle);
  }
  return rotation_xyz(Reader<Vec3d>::read(value, context));
}

Transform read_scale(const Value& value, const Context& context) {
  const Vec3d factors = read_factors(value, context);
  if (factors.x == 0.0 || factors.y == 0.0 || factors.z == 0.0) {
    context.fail("must not be 0: it would leave nothing");
  }
  return Transform::scaling(factors);
}

Transform read_mirror(const Value& value, const Context& context) {
  const Vec3d normal = Reader<Vec3d>::read(value, context);
  if (length(normal) == 0.0) context.fail("needs a normal that is not zero");
  return Transform::mirror(normal);
}

/// Three or four rows of four numbers; a fourth row must be {0, 0, 0, 1}.
Transform read_matrix(const Value& value, const Context& context) {
  const auto is_list = [](const Value& v, std::size_t least, std::size_t most) {
    return v.kind() == ValueKind::table && v.table().fields.empty() &&
           v.table().items.size() >= least && v.table().items.size() <= most;
  };
  if (!is_list(value, 3, 4)) schema::fail_type("three rows of four numbers", value, context);
  Mat3 linear;
  Vec3d offset;
  for (std::size_t i = 0; i < value.table().items.size(); ++i) {
    const Value& row = value.table().items[i];
    const Context row_context = context.at(i);
    if (!is_list(row, 4, 4)) schema::fail_type("a row of four numbers", row, row_context);
    for (std::size_t j = 0; j < 4; ++j) {
      const double x = Reader<double>::read(row.table().items[j], row_context.at(j));
      if (i == 3 && x != (j == 3 ? 1.0 : 0.0)) row_context.fail("must be {0, 0, 0, 1}");
      if (i == 3) continue;
      (j == 3 ? offset[i] : linear.row[i][j]) = x;
    }
  }
  const auto transform = Transform::affine(linear, offset);
  if (!transform) {
    context.fail("has no inverse: it would flatten what it moves",
                 "its first three columns must not lie in one plane");
  }
  return *transform;
}

schema::NodeInfo info(std::string name, std::string doc, std::vector<std::string> examples) {
  return {.name = std::move(name),
          .doc = std::move(doc),
          .section = "methods of objects",
          .examples = std::move(examples),
          .form = schema::Form::method,
          .parameters = {}};
}

}  // namespace

std::optional<AxisAngle> read_axis_angle(const Value& value, const Context& context) {
  if (!has_field(value, "axis") && !has_field(value, "angle")) return std::nullopt;
  static const auto declaration =
      schema::Declaration<AxisAngle>({.name = "rotate", .doc = ""})
          .parameter("axis", &AxisAngle::axis, {.need = schema::Need::required})
          .parameter("angle", &AxisAngle::angle, {.need = schema::Need::required});
  const auto [axis, angle] = declaration.read(value, context);
  if (length(axis) == 0.0) context.at("axis").fail("must not be zero");
  return AxisAngle{normalize(axis), radians(angle)};
}

Transform rotation_xyz(Vec3d degrees) {
  return turn(2, degrees.z) * (turn(1, degrees.y) * turn(0, degrees.x));
}

Vec3d read_factors(const Value& value, const Context& context) {
  if (value.kind() != ValueKind::number) return schema::read_vector(value, context, {1, 1, 1});
  const double s = Reader<double>::read(value, context);
  return {s, s, s};
}

std::vector<Move> moves() {
  return {
      {info("translate", "Moved by {x, y, z}; what is not named is 0. Textures can be moved, too.",
            {"ball:translate { 0, 0, 1.5 }", "ball:translate { z = 1.5 }",
             "checker {}:translate { x = 0.5 }"}),
       [](const Value& value, const Context& context) {
         return Transform::translation(Reader<Vec3d>::read(value, context));
       }},
      {info("rotate",
            "Turned by degrees {x, y, z} about x, then y, then z through {0, 0, 0}; or "
            "{axis = {x, y, z}, angle = degrees}.",
            {"ball:rotate { z = 45 }", "ball:rotate { axis = { 1, 1, 1 }, angle = 120 }"}),
       read_rotation},
      {info("scale",
            "Scaled about {0, 0, 0} by a number, or by {x, y, z}; what is not named "
            "is 1.",
            {"ball:scale(2)", "ball:scale { z = 0.5 }", "checker {}:scale(0.1)"}),
       read_scale},
      {info("mirror", "Mirrored in the plane through {0, 0, 0} with normal {x, y, z}.",
            {"ball:mirror { 1, 0, 0 }"}),
       read_mirror},
      {info("transform", "Mapped by three rows of four numbers; the last of each is the offset.",
            {"ball:transform { { 1, 0, 0.3, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 2 } }"}),
       read_matrix},
  };
}

}  // namespace lapidary::description
