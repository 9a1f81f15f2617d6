#include "texture/arithmetic.h"

namespace lapidary::texture {

Operand::Operand(const Operand&) = default;
Operand::Operand(Operand&&) noexcept = default;
Operand& Operand::operator=(const Operand&) = default;
Operand& Operand::operator=(Operand&&) noexcept = default;
Operand::~Operand() = default;

double Operand::at(const Lookup& lookup) const {
  if (const double* number = std::get_if<double>(&value_)) return *number;
  return std::get<Color>(value_).number_at(lookup);
}

double reckon(Arithmetic::Operation operation, double a, double b) {
  using Operation = Arithmetic::Operation;
  switch (operation) {
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      return b == 0.0 ? 0.0 : a / b;
    case Operation::power:
      return a < 0.0 ? 0.0 : std::pow(a, b);
    case Operation::minimum:
      return std::min(a, b);
    case Operation::maximum:
      return std::max(a, b);
    case Operation::add:
      break;
  }
  return a + b;
}

double value(const Arithmetic& arithmetic, const Lookup& lookup) {
  return held(reckon(arithmetic.operation, arithmetic.operands[0].at(lookup),
                     arithmetic.operands[1].at(lookup)));
}

double share_at(const Mix& mix, const Lookup& lookup) {
  return std::clamp(mix.share.at(lookup), 0.0, 1.0);
}

double value(const Mix& mix, const Lookup& lookup) {
  const double share = share_at(mix, lookup);
  if (share == 0.0) return mix.operands[0].at(lookup);
  if (share == 1.0) return mix.operands[1].at(lookup);
  return mix.operands[0].at(lookup) * (1.0 - share) + mix.operands[1].at(lookup) * share;
}

double value(const ChannelOf& channel, const Lookup& lookup) {
  const Rgb c = channel.input.rgb_at(lookup);
  switch (channel.channel) {
    case ChannelOf::Channel::red:
      return static_cast<double>(c.r);
    case ChannelOf::Channel::green:
      return static_cast<double>(c.g);
    case ChannelOf::Channel::blue:
      return static_cast<double>(c.b);
    case ChannelOf::Channel::luminance:
      break;
  }
  return static_cast<double>(luminance(c));
}

double ramp_position(const Remap& remap, const Lookup& lookup) {
  return std::clamp((remap.input.at(lookup) - remap.from) / (remap.to - remap.from), 0.0, 1.0);
}

double value(const Remap& remap, const Lookup& lookup) {
  if (remap.colors.stops.empty()) return ramp_position(remap, lookup);
  return static_cast<double>(luminance(color(remap, RgbPalette{}, lookup)));
}

}  // namespace lapidary::texture
