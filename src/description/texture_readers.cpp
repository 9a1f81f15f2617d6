#include "description/texture_readers.h"

#include <algorithm>
#include <span>

#include "description/color_readers.h"
#include "description/texture_parameters.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Value;
using schema::ValueKind;

/// The parts of {position, color}; three numbers are a colour.
std::span<const Value> parts_of_stop(const Value& value) {
  if (value.kind() != ValueKind::table || !value.table().fields.empty()) return {};
  const auto items = value.table().items;
  if (items.size() != 2 || items[0].kind() != ValueKind::number) return {};
  return items;
}

}  // namespace

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

texture::Operand OperandReader::read(const Value& value, const Context& context) {
  if (value.kind() == ValueKind::number) return schema::Reader<double>::read(value, context);
  return ColorReader::read(value, context);
}

std::array<texture::Color, 2> ColorPairReader::read(const Value& value, const Context& context) {
  const bool pair = value.kind() == ValueKind::table && value.table().items.size() == 2 &&
                    value.table().fields.empty();
  if (!pair) schema::fail_type("a list of two colors", value, context);
  const auto items = value.table().items;
  return {ColorReader::read(items[0], context.at(0)), ColorReader::read(items[1], context.at(1))};
}

texture::Ramp RampReader::read(const Value& value, const Context& context) {
  const bool list = value.kind() == ValueKind::table && value.table().fields.empty() &&
                    !value.table().items.empty();
  if (!list) schema::fail_type("a list of colors", value, context);
  const auto items = value.table().items;
  const bool positioned = !parts_of_stop(items[0]).empty();
  texture::Ramp ramp;
  ramp.origin = texture::Ramp::Origin::stated;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Context at = context.at(i);
    const auto parts = parts_of_stop(items[i]);
    if (positioned == parts.empty()) at.fail("must have a position as all others, or none has");
    double position =
        static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(items.size(), 2) - 1);
    if (positioned) {
      position = schema::Reader<double>::read(parts[0], at.at("position", schema::unit_interval));
      if (i > 0 && position < ramp.stops.back().position) {
        at.fail("must not come before the one above it", "positions go from 0 to 1");
      }
    }
    ramp.stops.push_back({position, ColorReader::read(positioned ? parts[1] : items[i], at)});
  }
  return ramp;
}

void check_extent(const texture::Texture& texture, const Location& where) {
  const auto [depth, looks] = texture.extent;
  if (depth <= most_of_a_texture.depth && looks <= most_of_a_texture.looks) return;
  throw Error(
      where,
      depth > most_of_a_texture.depth
          ? fmt::format("textures of textures are nested more than {} deep",
                        most_of_a_texture.depth)
          : fmt::format("a texture is made of more than {} others", most_of_a_texture.looks),
      "each of them is looked at for every point of a picture");
}

}  // namespace lapidary::description
