#include "texture/texture.h"

namespace lapidary::texture {
namespace {

template <typename Kind>
concept OfNumbers = requires(const Kind& kind, const Lookup& lookup) {
  { value(kind, lookup) } -> std::same_as<double>;
};
template <typename Kind>
concept OfColors = requires(const Kind& kind, const Lookup& lookup) {
  { color(kind, RgbPalette{}, lookup) } -> std::same_as<Rgb>;
};

}  // namespace

double evaluate(const Texture& texture, const Lookup& lookup) {
  return std::visit(
      [&](const auto& kind) -> double {
        if constexpr (OfNumbers<std::remove_cvref_t<decltype(kind)>>) {
          return value(kind, lookup);
        } else {
          return static_cast<double>(luminance(color(kind, RgbPalette{}, lookup)));
        }
      },
      texture.kind);
}

template <typename Palette>
typename Palette::Value evaluate(const Texture& texture, const Palette& palette,
                                 const Lookup& lookup) {
  return std::visit(
      [&](const auto& kind) -> typename Palette::Value {
        if constexpr (OfColors<std::remove_cvref_t<decltype(kind)>>) {
          return color(kind, palette, lookup);
        } else {
          const auto grey = static_cast<float>(value(kind, lookup));
          return palette.of(Rgb{grey, grey, grey});
        }
      },
      texture.kind);
}

template SampledSpectrum evaluate(const Texture&, const SpectralPalette&, const Lookup&);
template Rgb evaluate(const Texture&, const RgbPalette&, const Lookup&);

TexturePtr moved(const Texture& texture, const Transform& motion) {
  const auto* before = std::get_if<Moved>(&texture.kind);
  const Transform whole = before ? motion * before->texture_from_moved.inverse() : motion;
  if (!Transform::affine(whole.linear(), whole.offset())) return nullptr;
  TexturePtr inner = before ? before->texture : std::make_shared<const Texture>(texture);
  return std::make_shared<const Texture>(Texture{Moved{std::move(inner), whole.inverse()}});
}

double Number::evaluate(const Lookup& lookup) const {
  return texture::evaluate(*std::get<TexturePtr>(value_), lookup);
}

double Color::number_at(const Lookup& lookup) const {
  const Constant* same = constant();
  return same != nullptr ? static_cast<double>(luminance(same->rgb))
                         : texture::evaluate(*std::get<TexturePtr>(value_), lookup);
}

SampledSpectrum Color::evaluate(const SpectralPalette& palette, const Lookup& lookup) const {
  return texture::evaluate(*std::get<TexturePtr>(value_), palette, lookup);
}

Rgb Color::evaluate(const RgbPalette& palette, const Lookup& lookup) const {
  return texture::evaluate(*std::get<TexturePtr>(value_), palette, lookup);
}

}  // namespace lapidary::texture
