#include "description/color_readers.h"

#include <algorithm>
#include <charconv>
#include <vector>

#include <fmt/format.h>

#include "description/named_colors.h"
#include "spectrum/color.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Value;
using schema::ValueKind;

Rgb linear(std::uint32_t srgb) {
  const auto channel = [srgb](int shift) {
    return static_cast<float>((srgb >> shift) & 0xFF) / 255.0f;
  };
  return srgb_decode(Rgb{channel(16), channel(8), channel(0)});
}

/// 0xRRGGBB of "rgb" or "rrggbb".
std::optional<std::uint32_t> parse_hex(std::string_view digits) {
  std::uint32_t x = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, problem] = std::from_chars(digits.data(), end, x, 16);
  if (problem != std::errc() || stop != end) return std::nullopt;
  if (digits.size() == 6) return x;
  if (digits.size() != 3) return std::nullopt;
  return ((x & 0xF00) << 8 | (x & 0x0F0) << 4 | (x & 0x00F)) * 0x11;
}

Rgb named_color(std::string_view text, const Context& context) {
  if (text.starts_with('#')) {
    const auto srgb = parse_hex(text.substr(1));
    if (!srgb) {
      context.fail(
          fmt::format("must be a color such as \"#c08040\", not {}", Value(text).describe()),
          "three or six hexadecimal digits follow the #");
    }
    return linear(*srgb);
  }
  std::string name(text);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  });
  if (const auto srgb = find_named_color(name)) return linear(*srgb);
  std::vector<std::string_view> names;
  for (const NamedColor& color : named_colors()) names.push_back(color.name);
  std::string hint = schema::did_you_mean(name, names);
  if (hint.empty()) hint = "a color is \"#rrggbb\", a CSS name, linear {r, g, b} or a spectrum";
  context.fail(fmt::format("names no color: {}", Value(text).describe()), std::move(hint));
}

/// Any colour but a spectrum; components lie in `range`.
Rgb read_rgb(const Value& value, const Context& context, const schema::Range& range) {
  const auto component = [&](const Value& part, std::string_view name) {
    const Context within = name.empty() ? context : context.at(name);
    const double x = schema::Reader<double>::read(part, within);
    if (!range.contains(x)) within.fail(fmt::format("must be {}, not {}", range.text(), x));
    return static_cast<float>(x);
  };
  switch (value.kind()) {
    case ValueKind::string:
      return named_color(value.string(), context);
    case ValueKind::number: {
      const float grey = component(value, "");
      return {grey, grey, grey};
    }
    case ValueKind::table: {
      const auto [items, fields] = value.table();
      if (items.size() == 3 && fields.empty()) {
        return {component(items[0], "r"), component(items[1], "g"), component(items[2], "b")};
      }
      break;
    }
    default:
      break;
  }
  context.fail(fmt::format("must be a color, not {}", value.describe()),
               "a color is \"#rrggbb\", a CSS name, linear {r, g, b} or a spectrum");
}

std::shared_ptr<const Spectrum> as_spectrum(const Value& value) {
  return value.kind() == ValueKind::node ? value.node().as<Spectrum>() : nullptr;
}

}  // namespace

schema::NodeInfo color_info() {
  return {
      .name = "color",
      .doc =
          "What a parameter of type color takes: \"#rrggbb\", a CSS name, linear {r, g, b}, "
          "a number (grey), or a spectrum. Light may exceed 1, a surface may not.",
      .section = "values",
      .examples = {"matte \"#c08040\"", "matte \"tomato\"", "matte { color = { 0.5, 0.2, 0.1 } }",
                   "matte { color = 0.8 }",
                   "matte { color = spectrum { from = 500, step = 100, values = { 0, 0.9 } } }"},
      .form = schema::Form::other,
      .parameters = {}};
}

Spectrum ReflectanceReader::read(const Value& value, const Context& context) {
  const auto spectrum = as_spectrum(value);
  if (!spectrum) return Spectrum::reflectance(read_rgb(value, context, schema::unit_interval));
  for (const double nm : spectrum->knots()) {
    const double x = spectrum->at(nm);
    if (!(x >= 0.0 && x <= 1.0)) {
      context.fail(fmt::format("must reflect from 0 to 1, but is {} at {} nm", x, nm));
    }
  }
  return *spectrum;
}

Spectrum LightReader::read(const Value& value, const Context& context) {
  if (const auto spectrum = as_spectrum(value)) return *spectrum;
  // Beyond this, sums over the picture lose their meaning long before floats do.
  constexpr schema::Range range{.min = 0, .max = 1e30};
  return Spectrum::illuminant(read_rgb(value, context, range));
}

}  // namespace lapidary::description
