#pragma once

#include <array>
#include <cstdint>

#include "texture/operand.h"
#include "texture/ramp.h"

namespace lapidary::texture {

/// Two values reckoned with: numbers as numbers, colours wavelength by wavelength.
struct Arithmetic {
  enum class Operation : std::uint8_t {
    add,
    subtract,
    multiply,
    divide,  ///< by 0: 0
    power,   ///< of what is below 0: 0
    minimum,
    maximum,
  };
  Operation operation = Operation::add;
  std::array<Operand, 2> operands{0.0, 0.0};
};

/// Precondition: finite numbers. The result may be beyond what a number holds.
double reckon(Arithmetic::Operation operation, double a, double b);

/// The first, the second, or what is between them, by a share of the second in [0, 1].
struct Mix {
  std::array<Operand, 2> operands{0.0, 0.0};
  Number share = 0.5;
};

/// One of the components of a colour, in linear Rec. 709.
struct ChannelOf {
  enum class Channel : std::uint8_t { red, green, blue, luminance };
  Color input = Spectrum::constant(0.0f);
  Channel channel = Channel::luminance;
};

/// A ramp over the numbers of a texture; without colours, these from 0 to 1.
struct Remap {
  Number input;
  double from = 0, to = 1;  ///< which of them are 0 and 1 on the ramp; not the same
  Ramp colors;
};

template <typename Palette>
typename Palette::Value color(const Arithmetic& arithmetic, const Palette& palette,
                              const Lookup& lookup) {
  return componentwise(arithmetic.operands[0].in(palette, lookup),
                       arithmetic.operands[1].in(palette, lookup),
                       [&](double a, double b) { return reckon(arithmetic.operation, a, b); });
}
double value(const Arithmetic& arithmetic, const Lookup& lookup);

/// In [0, 1].
double share_at(const Mix& mix, const Lookup& lookup);

template <typename Palette>
typename Palette::Value color(const Mix& mix, const Palette& palette, const Lookup& lookup) {
  const double share = share_at(mix, lookup);
  if (share == 0.0) return mix.operands[0].in(palette, lookup);
  if (share == 1.0) return mix.operands[1].in(palette, lookup);
  const auto second = static_cast<float>(share);
  return mix.operands[0].in(palette, lookup) * (1.0f - second) +
         mix.operands[1].in(palette, lookup) * second;
}
double value(const Mix& mix, const Lookup& lookup);

double value(const ChannelOf& channel, const Lookup& lookup);

/// Where on the ramp a place is: in [0, 1].
double ramp_position(const Remap& remap, const Lookup& lookup);

template <typename Palette>
typename Palette::Value color(const Remap& remap, const Palette& palette, const Lookup& lookup) {
  return color_at(remap.colors, ramp_position(remap, lookup), palette, lookup);
}
double value(const Remap& remap, const Lookup& lookup);

}  // namespace lapidary::texture
