#pragma once

#include <variant>

#include "texture/arithmetic.h"
#include "texture/cells.h"
#include "texture/checker.h"
#include "texture/color.h"
#include "texture/gradient.h"
#include "texture/grid.h"
#include "texture/moved.h"
#include "texture/noise_textures.h"
#include "texture/picture.h"

/// Values over surfaces. A texture is a value itself, immutable and shared; textures are made of
/// others, which were there before them, so that there are no cycles.
///
/// Each kind is a plain struct with one of these functions beside it, or both:
///
///   template <typename Palette>
///   typename Palette::Value color(const Kind&, const Palette&, const Lookup&);   of colours
///   double value(const Kind&, const Lookup&);                                    of numbers
///
/// Where a kind has only numbers, a colour is a grey of that value; where it has only colours, a
/// number is their luminance. Values are whatever comes out, also beyond [0, 1]: who has limits
/// keeps them.
namespace lapidary::texture {

/// How much of others a texture is made of, each counted wherever it is looked at, and itself.
struct Extent {
  int depth = 1;
  double looks = 1;
};

struct Texture {
  using Kind = std::variant<Checker, Picture, Moved, Gradient, Clouds, Turbulence, Marble, Wood,
                            Voronoi, Grid, Bricks, Arithmetic, Mix, ChannelOf, Remap>;
  Kind kind;
  Extent extent;
  bool in_space = false;  ///< it asks for more than the surface's own coordinates

  Texture(Kind k);  // NOLINT: a kind is one
};

/// `texture` moved: `motion` comes after the motions it has. Null when the composed map is singular
/// to working precision or not finite.
TexturePtr moved(const Texture& texture, const Transform& motion);

double evaluate(const Texture& texture, const Lookup& lookup);
template <typename Palette>
typename Palette::Value evaluate(const Texture& texture, const Palette& palette,
                                 const Lookup& lookup);

}  // namespace lapidary::texture
