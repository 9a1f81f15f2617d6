#pragma once

#include "schema/node_info.h"
#include "schema/reader.h"
#include "spectrum/spectrum.h"

namespace lapidary::description {

// A colour in a scene is "#rrggbb" or "#rgb" (sRGB), a CSS name, linear {r, g, b}, a number (grey),
// or a spectrum { ... } or blackbody(kelvin). What it means depends on what it is for, so a
// parameter names one of these readers.

/// The above, for help.
schema::NodeInfo color_info();

/// The colour of a surface: a reflectance between 0 and 1.
struct ReflectanceReader {
  static std::string type() { return "color"; }
  static Spectrum read(const schema::Value& value, const schema::Context& context);
  static std::string text(const Spectrum&) { return ""; }
};

/// Light: a number is the total of a D65-shaped spectrum, {r, g, b} shows as {r, g, b}.
struct LightReader {
  static std::string type() { return "number or color"; }
  static Spectrum read(const schema::Value& value, const schema::Context& context);
  static std::string text(const Spectrum&) { return ""; }
};

/// `Reader` for what may be left out.
template <typename Reader>
struct Optional {
  using Value = decltype(Reader::read(std::declval<const schema::Value&>(),
                                      std::declval<const schema::Context&>()));

  static std::string type() { return Reader::type(); }
  static std::optional<Value> read(const schema::Value& value, const schema::Context& context) {
    return Reader::read(value, context);
  }
  static std::string text(const std::optional<Value>&) { return ""; }
};

}  // namespace lapidary::description
