#include "description/texture_readers.h"

#include "description/color_readers.h"

namespace lapidary::description {

using schema::Context;
using schema::Value;
using schema::ValueKind;

texture::Color ColorReader::read(const Value& value, const Context& context) {
  if (auto texture = schema::node_as<texture::Texture>(value)) return texture;
  return ReflectanceReader::read(value, context);
}

texture::Number NumberReader::read(const Value& value, const Context& context) {
  if (auto texture = schema::node_as<texture::Texture>(value)) return texture;
  if (value.kind() != ValueKind::number) schema::fail_type("a number or a texture", value, context);
  return schema::Reader<double>::read(value, context);
}

std::string NumberReader::text(const texture::Number& number) {
  const double* same = number.constant();
  return same != nullptr ? schema::Reader<double>::text(*same) : "";
}

std::array<texture::Color, 2> ColorPairReader::read(const Value& value, const Context& context) {
  const bool pair = value.kind() == ValueKind::table && value.table().items.size() == 2 &&
                    value.table().fields.empty();
  if (!pair) schema::fail_type("a list of two colors", value, context);
  const auto items = value.table().items;
  return {ColorReader::read(items[0], context.at(0)), ColorReader::read(items[1], context.at(1))};
}

}  // namespace lapidary::description
