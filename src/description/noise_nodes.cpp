#include "description/nodes.h"
#include "description/texture_parameters.h"
#include "description/texture_readers.h"

namespace lapidary::schema {

template <>
struct EnumNames<texture::Voronoi::Feature> {
  using Feature = texture::Voronoi::Feature;
  static constexpr std::array<std::pair<std::string_view, Feature>, 4> names{
      {{"f1", Feature::f1},
       {"f2", Feature::f2},
       {"edges", Feature::edges},
       {"cells", Feature::cells}}};
};

}  // namespace lapidary::schema

namespace lapidary::description {
namespace {

using schema::Declaration;
using schema::NodeKind;

constexpr auto section = "textures";
constexpr schema::Range octave_range{.min = 1, .max = 16};

/// Adds the parameters of T::octaves.
template <typename T>
Declaration<T>& declare_octaves(Declaration<T>& declaration) {
  declaration
      .parameter("octaves", [](T & t) -> auto& { return t.octaves.count; },
                 {.doc = "How many noises are added, each finer than the one before.",
                  .range = octave_range})
      .parameter("lacunarity", [](T & t) -> auto& { return t.octaves.lacunarity; },
                 {.doc = "How much finer each is.", .range = {.min = 1, .max = 10}})
      .parameter(
          "gain", [](T & t) -> auto& { return t.octaves.gain; },
          {.doc = "How high each is, beside the one before.", .range = schema::unit_interval});
  return declare_seed(
      declaration, [](T & t) -> auto& { return t.octaves.seed; });
}

constexpr schema::Range bend_range{.min = 0, .max = 100};

NodeKind noise() {
  Declaration<texture::Clouds> d(
      {.name = "noise",
       .doc = "Smooth random bumps, one wide, as a number about 0.5.",
       .section = section,
       .examples = {"noise {}",
                    "noise { colors = { \"saddlebrown\", \"tan\" }, seed = 7 }:scale(0.2)"}});
  declare_colors(d, "greys");
  declare_octaves(d);
  declare_mapping(d);
  return texture_kind(std::move(d));
}

struct Fbm : texture::Clouds {
  Fbm() { octaves.count = 6; }
};

NodeKind fbm() {
  Declaration<Fbm> d(
      {.name = "fbm",
       .doc = "Noise upon finer noise: clouds, dirt, weather.",
       .section = section,
       .examples = {"fbm { \"white\", \"skyblue\" }", "fbm { octaves = 8, gain = 0.6 }"}});
  declare_colors(d, "greys");
  declare_octaves(d);
  declare_mapping(d);
  return node_kind(std::move(d), [](Fbm&& f, const schema::Context& context) {
    return texture_node(texture::Clouds(std::move(f)), context);
  });
}

NodeKind turbulence() {
  Declaration<texture::Turbulence> d(
      {.name = "turbulence",
       .doc = "Billows with dark creases between, as of smoke.",
       .section = section,
       .examples = {"turbulence { \"black\", \"orange\", \"white\" }"}});
  declare_colors(d, "greys");
  declare_octaves(d);
  declare_mapping(d);
  return texture_kind(std::move(d));
}

NodeKind marble() {
  using texture::Marble;
  Declaration<Marble> d(
      {.name = "marble",
       .doc = "Layers across x, one for each unit, bent by noise.",
       .section = section,
       .examples = {"marble {}", "marble { \"black\", \"#204030\", \"white\" }:scale(0.3)"}});
  declare_colors(d, "white with dark veins");
  d.parameter("turbulence", &Marble::turbulence,
              {.doc = "How far they are bent.", .range = bend_range});
  declare_octaves(d);
  declare_mapping(d);
  return texture_kind(std::move(d));
}

NodeKind wood() {
  using texture::Wood;
  Declaration<Wood> d(
      {.name = "wood",
       .doc = "Rings around the z axis, one for each unit, with fibres along it.",
       .section = section,
       .examples = {"wood {}:scale(0.1)",
                    "wood { \"#c89a62\", \"#7a4a22\" }:rotate { y = 85 }:scale(0.1)"}});
  declare_colors(d, "browns");
  d.parameter("turbulence", &Wood::turbulence,
              {.doc = "How wavy the rings are.", .range = bend_range})
      .parameter("grain", &Wood::grain,
                 {.doc = "How much the fibres show.", .range = {.min = 0, .max = 10}});
  declare_seed(d, &Wood::seed);
  declare_mapping(d);
  return texture_kind(std::move(d));
}

NodeKind voronoi() {
  using texture::Voronoi;
  Declaration<Voronoi> d(
      {.name = "voronoi",
       .doc = "Cells about random points, one to a unit: stones, leather, scales, cracks.",
       .section = section,
       .examples = {"voronoi {}",
                    "voronoi { colors = { \"black\", \"white\" }, feature = \"edges\" }",
                    "voronoi { colors = { \"#806040\", \"#c0a080\" }, feature = \"cells\" }"}});
  declare_colors(d, "greys");
  d.parameter(
       "feature", &Voronoi::feature,
       {.doc = "The distance to the nearest point, to the second, their difference, which is "
               "0 on boundaries, or a number for each cell."})
      .parameter("scatter", &Voronoi::scatter,
                 {.doc = "From 0, points in rows, to 1, points anywhere.",
                  .range = schema::unit_interval});
  declare_seed(d, &Voronoi::seed);
  declare_mapping(d);
  return texture_kind(std::move(d));
}

}  // namespace

std::vector<NodeKind> noise_kinds() {
  return {noise(), fbm(), turbulence(), marble(), wood(), voronoi()};
}

}  // namespace lapidary::description
