#include "description/node_readers.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Value;
using schema::ValueKind;

template <typename Reader>
void collect(const Value& value, const Context& context, std::vector<ObjectPtr>& objects) {
  if (value.kind() == ValueKind::table && value.table().fields.empty()) {
    const auto items = value.table().items;
    for (std::size_t i = 0; i < items.size(); ++i) {
      collect<Reader>(items[i], context.at(i), objects);
    }
    return;
  }
  objects.push_back(Reader::read(value, context));
}

std::string why_object_is_no_solid(const Value& value, const Object& object) {
  const auto* sheet = std::get_if<geometry::Sheet>(&object.content);
  const std::string kind = value.describe();
  if (!sheet) return kind + " holds something that encloses nothing";
  const bool round = std::holds_alternative<geometry::Disk>(*sheet);
  return kind + " encloses nothing: use " + (round ? "a flat cylinder" : "a thin box");
}

}  // namespace

std::vector<ObjectPtr> ObjectListReader::read(const Value& value, const Context& context) {
  std::vector<ObjectPtr> objects;
  collect<schema::Reader<ObjectPtr>>(value, context, objects);
  return objects;
}

std::string why_no_solid(const Value& value) {
  if (const auto object = schema::node_as<Object>(value)) {
    return is_solid(*object) ? "" : why_object_is_no_solid(value, *object);
  }
  if (schema::node_as<Material>(value)) return "a solid wears it so: solid:material(...)";
  if (schema::node_as<Light>(value)) return value.describe() + " is light without a body";
  if (value.is_nil()) return "does a name have a slip, or does a function return nothing?";
  if (value.kind() == ValueKind::table) return "union { ... } makes one solid of a list";
  if (value.kind() == ValueKind::number) return "solid:translate and solid:scale take numbers";
  if (value.kind() == ValueKind::other && value.describe() == "a function") {
    return "call it: name { ... }";
  }
  return "only solids can be combined";
}

ObjectPtr SolidReader::read(const Value& value, const Context& context) {
  const std::string problem = why_no_solid(value);
  if (problem.empty()) return schema::node_as<Object>(value);
  context.fail("must be a solid, not " + value.describe(), problem);
}

std::vector<ObjectPtr> SolidListReader::read(const Value& value, const Context& context) {
  std::vector<ObjectPtr> solids;
  collect<SolidReader>(value, context, solids);
  return solids;
}

MaterialPtr InteriorReader::read(const Value& value, const Context& context) {
  MaterialPtr material = schema::node_as<Material>(value);
  if (material && std::holds_alternative<Glass>(material->model)) return material;
  schema::fail_type("a glass", value, context);
}

std::optional<Cut> CutReader::read(const Value& value, const Context& context) {
  if (MaterialPtr material = schema::node_as<Material>(value)) {
    return Cut{Cut::Rule::material, std::move(material)};
  }
  constexpr std::array<std::string_view, 2> words{"cutter", "inherit"};
  if (value.kind() != ValueKind::string) {
    schema::fail_type("\"cutter\", \"inherit\" or a material", value, context);
  }
  const bool inherits = schema::read_word(value, words, context) == 1;
  return Cut{inherits ? Cut::Rule::inherit : Cut::Rule::cutter, nullptr};
}

}  // namespace lapidary::description
