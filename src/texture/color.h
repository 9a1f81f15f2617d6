#pragma once

#include <array>
#include <memory>
#include <variant>

#include "texture/lookup.h"
#include "texture/palette.h"

namespace lapidary::texture {

struct Texture;
using TexturePtr = std::shared_ptr<const Texture>;

/// A number of a material: the same everywhere, or from a texture.
class Number {
 public:
  Number(double value = 0) : value_(value) {}                 // NOLINT: a number is one
  Number(TexturePtr texture) : value_(std::move(texture)) {}  // NOLINT

  /// The value that is the same everywhere; null when it is a texture's.
  const double* constant() const { return std::get_if<double>(&value_); }
  /// Null when it is the same everywhere.
  const TexturePtr* texture() const { return std::get_if<TexturePtr>(&value_); }
  double at(const Lookup& lookup) const {
    const double* same = constant();
    return same != nullptr ? *same : evaluate(lookup);
  }
  bool operator==(const Number&) const = default;  ///< textures: the very same one

 private:
  double evaluate(const Lookup& lookup) const;

  std::variant<double, TexturePtr> value_;
};

/// A colour of a material: the same everywhere, or from a texture. No unit: a share of light that
/// is reflected or let through, or a factor of what is emitted.
class Color {
 public:
  Color(Constant value) : value_(std::move(value)) {}            // NOLINT
  Color(Spectrum value) : value_(Constant(std::move(value))) {}  // NOLINT
  Color(TexturePtr texture) : value_(std::move(texture)) {}      // NOLINT

  const Constant* constant() const { return std::get_if<Constant>(&value_); }
  /// Null when it is the same everywhere.
  const TexturePtr* texture() const { return std::get_if<TexturePtr>(&value_); }
  SampledSpectrum at(const Lookup& lookup, const Wavelengths& wavelengths) const {
    return in(SpectralPalette{wavelengths}, lookup);
  }
  Rgb rgb_at(const Lookup& lookup) const { return in(RgbPalette{}, lookup); }
  /// As a number: of a constant the luminance, else what the texture has for one.
  double number_at(const Lookup& lookup) const;
  /// The same for those who do not know which: see palette.h.
  template <typename Palette>
  typename Palette::Value in(const Palette& palette, const Lookup& lookup) const {
    const Constant* same = constant();
    return same != nullptr ? palette.of(*same) : evaluate(palette, lookup);
  }
  bool operator==(const Color&) const = default;  ///< textures: the very same one

 private:
  SampledSpectrum evaluate(const SpectralPalette& palette, const Lookup& lookup) const;
  Rgb evaluate(const RgbPalette& palette, const Lookup& lookup) const;

  std::variant<Constant, TexturePtr> value_;
};

/// One colour, the other, or a mixture with `share` of the second. The one that does not count is
/// not looked at.
template <typename Palette>
typename Palette::Value blend(const std::array<Color, 2>& colors, double share,
                              const Palette& palette, const Lookup& lookup) {
  if (!(share > 0.0)) return colors[0].in(palette, lookup);
  if (!(share < 1.0)) return colors[1].in(palette, lookup);
  const auto second = static_cast<float>(share);
  return colors[0].in(palette, lookup) * (1.0f - second) + colors[1].in(palette, lookup) * second;
}

}  // namespace lapidary::texture
