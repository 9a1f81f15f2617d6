#include "description/methods.h"

#include <cmath>

#include <fmt/format.h>

#include "description/node_readers.h"
#include "math/constants.h"

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

/// About a coordinate axis, exact for quarter turns: parts that are turned squarely keep faces that
/// coincide to the last bit.
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

/// As {axis = {x, y, z}, angle = degrees}; nothing if it is written in another way.
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

Transform read_rotation(const Value& value, const Context& context) {
  if (const auto turned = read_axis_angle(value, context)) {
    return Transform::rotation(turned->axis, turned->angle);
  }
  return rotation_xyz(Reader<Vec3d>::read(value, context));
}

Vec3d read_factors(const Value& value, const Context& context) {
  if (value.kind() != ValueKind::number) return schema::read_vector(value, context, {1, 1, 1});
  const double s = Reader<double>::read(value, context);
  return {s, s, s};
}

Transform read_scale(const Value& value, const Context& context) {
  const Vec3d factors = read_factors(value, context);
  if (factors.x == 0.0 || factors.y == 0.0 || factors.z == 0.0) {
    context.fail("must not be 0: it would leave the object no extent");
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
    context.fail("has no inverse: it would flatten the object",
                 "its first three columns must not lie in one plane");
  }
  return *transform;
}

using ReadMove = Transform (*)(const Value&, const Context&);

Method move(schema::NodeInfo info, ReadMove read) {
  return {std::move(info),
          [read](const Object& object, const Value& argument, const schema::Call& call) {
            const Context context(call);
            ObjectPtr result = moved(object, read(argument, context));
            if (!result) {
              context.fail("together with the motions before it leaves nothing of the object",
                           "the whole map is singular or overflows");
            }
            return result;
          }};
}

schema::NodeInfo info(std::string name, std::string doc, std::vector<std::string> examples) {
  return {.name = std::move(name),
          .doc = std::move(doc),
          .section = "methods of objects",
          .examples = std::move(examples),
          .form = schema::Form::method,
          .parameters = {}};
}

/// A turn that keeps its whole turns where it is about one axis, and else is the least one.
struct TurnReader {
  static std::string type() { return "degrees {x, y, z}, or {axis = , angle = }"; }
  static AxisAngle read(const Value& value, const Context& context) {
    if (const auto turned = read_axis_angle(value, context)) return *turned;
    const Vec3d angles = Reader<Vec3d>::read(value, context);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vec3d alone;
      alone[axis] = 1.0;
      const bool is_alone = angles[(axis + 1) % 3] == 0.0 && angles[(axis + 2) % 3] == 0.0;
      if (is_alone) return {alone, radians(angles[axis])};
    }
    return least_turn(rotation_xyz(angles).linear());
  }
  static std::string text(const AxisAngle&) { return ""; }
};

struct FactorsReader {
  static std::string type() { return "number or {x, y, z}"; }
  static Vec3d read(const Value& value, const Context& context) {
    return read_factors(value, context);
  }
  static std::string text(const Vec3d&) { return "1"; }
};

schema::Declaration<geometry::Motion> declare_motion() {
  using geometry::Motion;
  schema::Declaration<Motion> d(
      {.name = "motion",
       .doc = "The object moving while the picture is taken: where it is when the frame ends, from "
              "where it stands. The shutter of the camera says how much of the frame is seen.",
       .section = "methods of objects",
       .examples = {"ball:motion { translate = { 0.5, 0, 0 } }",
                    "ball:motion { rotate = { z = 40 }, scale = 1.1 }"},
       .form = schema::Form::method});
  d.parameter("translate", &Motion::travel,
              {.doc = "How far it goes, straight on.", .unit = schema::Unit::length})
      .parameter<TurnReader>("rotate", &Motion::turn,
                             {.doc = "How far it turns about the origin of its own coordinates, at "
                                     "a constant rate about one axis; about x, y or z alone it may "
                                     "be several times around.",
                              .unit = schema::Unit::degrees,
                              .range = {.min = -36000, .max = 36000}})
      .parameter<FactorsReader>(
          "scale", &Motion::scale,
          {.doc = "How many times larger it becomes.", .range = {.min = 1e-3, .max = 1e3}});
  return d;
}

Method motion() {
  auto declaration = declare_motion();
  schema::NodeInfo shown = declaration.info();
  return {std::move(shown),
          [declaration = std::move(declaration)](const Object& object, const Value& argument,
                                                 const schema::Call& call) {
            const Context context(call);
            if (object.motion) {
              context.fail("is given to what moves already",
                           "put it into a group: the motion of that comes on top");
            }
            return with_motion(object, declaration.read(argument, context));
          }};
}

ObjectPtr apply_name(const Object& object, const Value& argument, const schema::Call& call) {
  return with_name(object, Reader<std::string>::read(argument, Context(call)));
}

ObjectPtr apply_material(const Object& object, const Value& argument, const schema::Call& call) {
  return with_material(object, Reader<MaterialPtr>::read(argument, Context(call)));
}

/// A method of what encloses something, or holds what does.
template <typename Change>
Method solid_method(schema::NodeInfo info, Change change) {
  return {std::move(info),
          [change](const Object& object, const Value& argument, const schema::Call& call) {
            const Context context(call);
            if (std::holds_alternative<geometry::Sheet>(object.content)) {
              context.fail("is for solids: a sheet encloses nothing");
            }
            return change(object, argument, context);
          }};
}

Method apply_interior() {
  return solid_method(info("interior", "The solid filled with a glass, whatever its surface wears.",
                           {"ball:interior(glass \"water\")"}),
                      [](const Object& object, const Value& argument, const Context& context) {
                        return with_attributes(
                            object, {.interior = InteriorReader::read(argument, context)});
                      });
}

Method apply_priority() {
  return solid_method(
      info("priority", "Where solids overlap, the one of the greater number fills the overlap.",
           {"ball:priority(1)"}),
      [](const Object& object, const Value& argument, const Context& context) {
        return with_attributes(object, {.priority = Reader<std::int32_t>::read(argument, context)});
      });
}

Method apply_cut() {
  return solid_method(
      info("cut",
           "Where it is cut it wears \"cutter\": what the cutter wears, if anything; \"inherit\": "
           "what was cut; or a material.",
           {"ball:cut \"inherit\"", "ball:cut(matte \"#c04030\")"}),
      [](const Object& object, const Value& argument, const Context& context) {
        return with_attributes(object, {.cut = CutReader::read(argument, context)});
      });
}

Method apply_section() {
  return solid_method(info("section", "The object without what is in a solid, to show the inside.",
                           {"ball:section(half_space { normal = { 0, 1, 0 } })"}),
                      [](const Object& object, const Value& argument, const Context& context) {
                        return with_section(std::make_shared<Object>(object),
                                            SolidReader::read(argument, context));
                      });
}

}  // namespace

std::vector<Method> object_methods() {
  return {
      {info("material",
            "The object wearing a material; parts of a group or a combination that wear one keep "
            "it.",
            {"ball:material(glass \"N-BK7\")",
             "ball:material(metal { \"gold\", roughness = 0.1 })"}),
       apply_material},
      apply_interior(),
      apply_priority(),
      apply_cut(),
      apply_section(),
      {info("name", "The object with a name, for reports and layers.", {"ball:name \"moon\""}),
       apply_name},
      move(info("translate", "Moved by {x, y, z}; what is not named is 0.",
                {"ball:translate { 0, 0, 1.5 }", "ball:translate { z = 1.5 }"}),
           [](const Value& value, const Context& context) {
             return Transform::translation(Reader<Vec3d>::read(value, context));
           }),
      move(info("rotate",
                "Turned by degrees {x, y, z} about x, then y, then z through {0, 0, 0}; or "
                "{axis = {x, y, z}, angle = degrees}.",
                {"ball:rotate { z = 45 }", "ball:rotate { axis = { 1, 1, 1 }, angle = 120 }"}),
           read_rotation),
      move(info("scale",
                "Scaled about {0, 0, 0} by a number, or by {x, y, z}; what is not named "
                "is 1.",
                {"ball:scale(2)", "ball:scale { z = 0.5 }"}),
           read_scale),
      move(info("mirror", "Mirrored in the plane through {0, 0, 0} with normal {x, y, z}.",
                {"ball:mirror { 1, 0, 0 }"}),
           read_mirror),
      move(
          info("transform", "Mapped by three rows of four numbers; the last of each is the offset.",
               {"ball:transform { { 1, 0, 0.3, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 2 } }"}),
          read_matrix),
      motion(),
  };
}

}  // namespace lapidary::description
