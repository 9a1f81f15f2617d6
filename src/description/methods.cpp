#include "description/methods.h"

#include "description/motions.h"
#include "description/node_readers.h"
#include "texture/texture.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Reader;
using schema::Value;

/// `motion` of an object or a texture.
template <typename T>
MethodOf<T> method_of(const Motion& motion) {
  return {motion.info,
          [read = motion.read](const T& thing, const Value& argument, const schema::Call& call) {
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
  for (const Motion& motion : motions()) methods.push_back(method_of<Object>(motion));
  return methods;
}

std::vector<TextureMethod> texture_methods() {
  std::vector<TextureMethod> methods;
  for (const Motion& motion : motions()) methods.push_back(method_of<texture::Texture>(motion));
  return methods;
}

}  // namespace lapidary::description
