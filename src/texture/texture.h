#pragma once

#include <variant>

#include "texture/checker.h"
#include "texture/color.h"

/// Values over surfaces. A texture is a value itself, immutable and shared; textures are made of
/// others, which were there before them, so that there are no cycles.
///
/// Each kind is a plain struct with one function beside it:
///
///   template <typename Palette>
///   typename Palette::Value color(const Kind&, const Palette&, const Lookup&);   of colours
///   double value(const Kind&, const Lookup&);                                    of numbers
///
/// A number where a colour is wanted is a grey of that value; a colour where a number is wanted is
/// its luminance. Values are whatever comes out, also beyond [0, 1]: who has limits keeps them.
namespace lapidary::texture {

struct Texture {
  using Kind = std::variant<Checker>;
  Kind kind;
};

double evaluate(const Texture& texture, const Lookup& lookup);
template <typename Palette>
typename Palette::Value evaluate(const Texture& texture, const Palette& palette,
                                 const Lookup& lookup);

}  // namespace lapidary::texture
