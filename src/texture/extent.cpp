#include <algorithm>

#include "texture/texture.h"

namespace lapidary::texture {
namespace {

/// Adds up the extents of what a kind is made of.
struct Inputs {
  int depth = 0;
  double looks = 0;
  bool in_space = false;

  void add(const TexturePtr& texture) {
    const Extent extent = texture->extent;
    depth = std::max(depth, extent.depth);
    looks += extent.looks;
    in_space |= texture->in_space;
  }
  void add(const Color& color) {
    if (const TexturePtr* texture = color.texture()) add(*texture);
  }
  void add(const Number& number) {
    if (const TexturePtr* texture = number.texture()) add(*texture);
  }
  void add(const Operand& operand) {
    if (const Color* color = operand.color()) add(*color);
  }
  void add(const Ramp& ramp) {
    for (const Ramp::Stop& stop : ramp.stops) add(stop.color);
  }
  template <typename T>
  void add(const std::array<T, 2>& pair) {
    add(pair[0]);
    add(pair[1]);
  }

  void of(const Picture&) {}
  void of(const Moved& moved) { add(moved.texture); }
  void of(const Checker& checker) { add(checker.colors); }
  void of(const Grid& grid) { add(grid.colors); }
  void of(const Bricks& bricks) {
    add(bricks.colors);
    add(bricks.mortar);
  }
  void of(const Arithmetic& arithmetic) { add(arithmetic.operands); }
  void of(const Mix& mix) {
    add(mix.operands);
    add(mix.share);
  }
  void of(const ChannelOf& channel) { add(channel.input); }
  void of(const Remap& remap) {
    add(remap.input);
    add(remap.colors);
  }
  template <Pattern Kind>
  void of(const Kind& pattern) {
    add(pattern.colors);
  }
};

template <typename Kind>
bool is_in_space(const Kind& kind) {
  if constexpr (requires { kind.mapping; }) {
    return kind.mapping.projection != Projection::uv;
  } else {
    return false;
  }
}

}  // namespace

Texture::Texture(Kind k) : kind(std::move(k)) {
  Inputs inputs;
  std::visit(
      [&](const auto& known) {
        inputs.of(known);
        in_space = inputs.in_space || is_in_space(known);
      },
      kind);
  extent = {inputs.depth + 1, inputs.looks + 1.0};
}

}  // namespace lapidary::texture
