#pragma once

#include <algorithm>
#include <cmath>
#include <variant>

#include "spectrum/color.h"
#include "texture/color.h"

namespace lapidary::texture {

/// What is reckoned with: a number, of any size, or a colour, which may be a texture's.
class Operand {
 public:
  Operand(double number) : value_(number) {}          // NOLINT: a number is one
  Operand(Color color) : value_(std::move(color)) {}  // NOLINT

  // Not inline: GCC 12 sees numbers where colours are, and warns.
  Operand(const Operand&);
  Operand(Operand&&) noexcept;
  Operand& operator=(const Operand&);
  Operand& operator=(Operand&&) noexcept;
  ~Operand();

  double at(const Lookup& lookup) const;
  template <typename Palette>
  typename Palette::Value in(const Palette& palette, const Lookup& lookup) const {
    if (const Color* color = this->color()) return color->in(palette, lookup);
    const auto grey = static_cast<float>(std::get<double>(value_));
    return palette.of(Rgb{grey, grey, grey});
  }
  const Color* color() const { return std::get_if<Color>(&value_); }

 private:
  std::variant<double, Color> value_;
};

/// Finite, for whoever goes on with it.
inline double held(double x) {
  return std::clamp(x, -1e30, 1e30);
}

// `f` of each component of finite colours.
template <typename F>
Rgb componentwise(Rgb a, Rgb b, const F& f) {
  const auto of = [&](float x, float y) {
    return static_cast<float>(held(f(static_cast<double>(x), static_cast<double>(y))));
  };
  return {of(a.r, b.r), of(a.g, b.g), of(a.b, b.b)};
}
template <typename F>
SampledSpectrum componentwise(SampledSpectrum a, SampledSpectrum b, const F& f) {
  SampledSpectrum result;
  for (std::size_t i = 0; i < SampledSpectrum::size; ++i) {
    const double x = f(static_cast<double>(a[i]), static_cast<double>(b[i]));
    result.set(i, static_cast<float>(held(x)));
  }
  return result;
}

}  // namespace lapidary::texture
