#include "description/methods.h"

#include "description/moves.h"
#include "description/node_readers.h"
#include "texture/texture.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Reader;
using schema::Value;

/// `move` of an object or a texture.
template <typename T>
MethodOf<T> method_of(const Move& move) {
  return {move.info,
          [read = move.read](const T& thing, const Value& argument, const schema::Call& call) {
            const Context context(call);
            std::shared_ptr<const T> result = moved(thing, read(argument, context));
            if (!result) {
              context.fail("together with the motions before it leaves nothing",
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
  std::vector<Method> methods{
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
  };
  for (const Move& move : moves()) methods.push_back(method_of<Object>(move));
  methods.push_back(motion());
  return methods;
}

std::vector<TextureMethod> texture_methods() {
  std::vector<TextureMethod> methods;
  for (const Move& move : moves()) methods.push_back(method_of<texture::Texture>(move));
  return methods;
}

}  // namespace lapidary::description
