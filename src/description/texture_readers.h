#pragma once

#include <array>

#include "description/node_readers.h"
#include "texture/texture.h"

namespace lapidary::description {

// What varies over a surface in a scene is a texture node; where one may stand, so may the
// constant.

/// The colour of a surface: whatever ReflectanceReader takes, or a texture.
struct ColorReader {
  static std::string type() { return "color or texture"; }
  static texture::Color read(const schema::Value& value, const schema::Context& context);
  static std::string text(const texture::Color&) { return ""; }
};

/// A number within the context's range, or a texture, which may leave it: that is for whoever uses
/// the number to limit.
struct NumberReader {
  static std::string type() { return "number or texture"; }
  static texture::Number read(const schema::Value& value, const schema::Context& context);
  static std::string text(const texture::Number& number);
};

/// Anything that textures can be reckoned with: a texture, a number of any size, or a colour.
struct OperandReader {
  static std::string type() { return "texture, number or color"; }
  static texture::Operand read(const schema::Value& value, const schema::Context& context);
};

/// Two colours, in a list.
struct ColorPairReader {
  static std::string type() { return "list of two colors or textures"; }
  static std::array<texture::Color, 2> read(const schema::Value& value,
                                            const schema::Context& context);
  static std::string text(const std::array<texture::Color, 2>&) { return ""; }
};

/// Colours from 0 to 1, evenly spaced, or each with its position: { { 0, "red" }, { 0.3, "blue" }
/// }.
struct RampReader {
  static std::string type() { return "list of colors, or of {position, color}"; }
  static texture::Ramp read(const schema::Value& value, const schema::Context& context);
  static std::string text(const texture::Ramp&) { return ""; }
};

}  // namespace lapidary::description
