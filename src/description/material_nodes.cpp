#include <fmt/format.h>

#include "description/color_readers.h"
#include "description/emission_parameters.h"
#include "description/material_node.h"
#include "description/node_readers.h"
#include "description/nodes.h"
#include "description/surface_detail.h"
#include "description/texture_readers.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::Node;
using schema::NodeKind;
using schema::Shorthand;
using schema::Value;
using schema::ValueKind;

/// Fails because `value` is no name in a catalogue.
[[noreturn]] void fail_catalogue(const std::vector<std::string>& names, std::string_view wanted,
                                 const Value& value, const Context& context) {
  const std::vector<std::string_view> known(names.begin(), names.end());
  std::string hint = schema::did_you_mean(value.string(), known);
  if (hint.empty()) hint = fmt::format("known are {}", fmt::join(names, ", "));
  context.fail(fmt::format("names no {}: {}", wanted, value.describe()), std::move(hint));
}

struct MetalIndexReader {
  static std::string type() { return "name"; }
  static std::optional<ConductorIndex> read(const Value& value, const Context& context) {
    if (value.kind() != ValueKind::string) schema::fail_type("the name of a metal", value, context);
    if (auto index = find_metal(value.string())) return index;
    fail_catalogue(metal_names(), "metal", value, context);
  }
  static std::string text(const std::optional<ConductorIndex>&) { return ""; }
};

struct MetalParameters {
  std::optional<ConductorIndex> index;
  std::optional<texture::Color> color;
  std::optional<Spectrum> n, k;
  texture::Number roughness;
  bsdf::Brushing brushing;
};

Metal to_metal(const MetalParameters& m, const Context& context) {
  const bool spectra = m.n || m.k;
  if (int{m.index.has_value()} + int{m.color.has_value()} + int{spectra} > 1) {
    context.fail("takes one of 'ior', 'color', or 'n' with 'k'");
  }
  if (spectra && !(m.n && m.k)) context.fail("needs both 'n' and 'k'");
  Metal metal;
  metal.roughness = m.roughness;
  metal.brushing = m.brushing;
  if (m.index) metal.surface = *m.index;
  if (spectra) metal.surface = ConductorIndex{*m.n, *m.k};
  if (m.color) metal.surface = *m.color;
  return metal;
}

NodeKind matte() {
  using M = Detailed<Matte>;
  Declaration<M> d({.name = "matte",
                    .doc = "Diffuse, like chalk or plaster.",
                    .section = materials_section,
                    .examples = {"matte \"#d8cfc0\"", "matte { color = { 0.7, 0.6, 0.5 } }",
                                 "matte(checker { \"white\", \"black\" })",
                                 "matte { \"sienna\", roughness = 1 }"}});
  d.parameter<ColorReader>("color", &Matte::color,
                           {.doc = "Share of the light it gives back.",
                            .shorthand = Shorthand::yes,
                            .default_text = "{0.8, 0.8, 0.8}"})
      .parameter<NumberReader>("roughness", &Matte::roughness,
                               {.doc = "0 is smooth plaster, 1 is as flat as the full moon.",
                                .range = schema::unit_interval});
  return node_kind(declare_detail(d), [](M&& m, const Context& context) {
    SurfaceDetail detail = std::move(m.detail);
    return material_node(Matte(std::move(m)), std::move(detail), context);
  });
}

NodeKind metal() {
  using M = Detailed<MetalParameters>;
  Declaration<M> d({.name = "metal",
                    .doc = "A conductor, from mirror to brushed.",
                    .section = materials_section,
                    .examples = {"metal \"gold\"", "metal { \"gold\", roughness = 0.1 }",
                                 "metal { \"aluminium\", roughness = 0.4, anisotropy = 0.9 }",
                                 "metal { color = \"#8c2f39\", roughness = 0.3 }"}});
  d.parameter<MetalIndexReader>(
       "ior", &MetalParameters::index,
       {.doc = fmt::format("A measured metal: {}.", fmt::join(metal_names(), ", ")),
        .shorthand = Shorthand::yes})
      .parameter<Optional<ColorReader>>(
          "color", &MetalParameters::color,
          {.doc = "What it reflects head on, instead of 'ior'.", .default_text = "{0.9, 0.9, 0.9}"})
      .parameter("n", &MetalParameters::n, {.doc = "Real part of its refractive index, with 'k'."})
      .parameter("k", &MetalParameters::k,
                 {.doc = "Imaginary part (extinction) of its refractive index, with 'n'."})
      .parameter<NumberReader>("roughness", &MetalParameters::roughness,
                               {.doc = roughness_doc, .range = schema::unit_interval});
  declare_brushing(
      d, "", [](M & m) -> auto& { return m.brushing; });
  return node_kind(declare_detail(d), [](M&& m, const Context& context) {
    return material_node(to_metal(m, context), std::move(m.detail), context);
  });
}

struct GlassParameters : bsdf::Glass {
  std::optional<Spectrum> color;
  std::optional<double> distance;
};

Glass to_glass(GlassParameters&& g, const Context& context) {
  if (g.distance && !g.color) {
    context.fail("takes 'distance' only with a 'color'",
                 "light has that colour after the distance");
  }
  Glass glass{std::move(g), std::nullopt};
  if (g.color) glass.absorption = Absorption{*std::move(g.color), g.distance.value_or(1.0)};
  return glass;
}

NodeKind glass() {
  using G = Detailed<GlassParameters>;
  Declaration<G> d(
      {.name = "glass",
       .doc = "Clear: glass, water, gems.",
       .section = materials_section,
       .examples = {"glass \"N-BK7\"", "glass(1.5)", "glass { \"N-BK7\", roughness = 0.1 }"}});
  d.parameter<GlassIndexReader>(
       "ior", &G::index,
       {.doc = fmt::format("Index of refraction, or one of: {}.", fmt::join(glass_names(), ", ")),
        .range = {.min = 1, .max = 10},
        .shorthand = Shorthand::yes})
      .parameter<NumberReader>("roughness", &G::roughness,
                               {.doc = roughness_doc, .range = schema::unit_interval});
  declare_brushing(
      d, "", [](G & g) -> auto& { return g.brushing; });
  d.parameter<Optional<ReflectanceReader>>(
       "color", &G::color,
       {.doc = "What it tints: the colour of white light after 'distance' in it; clear when "
               "left out."})
      .parameter("distance", &G::distance,
                 {.doc = "How far light goes in it to have its 'color'.",
                  .unit = schema::Unit::length,
                  .range = schema::positive,
                  .default_text = "1"});
  return node_kind(declare_relief(d), [](G&& g, const Context& context) {
    SurfaceDetail detail = std::move(g.detail);
    return material_node(to_glass(std::move(g), context), std::move(detail), context);
  });
}

NodeKind emissive() {
  static constexpr auto strengths = {Strength::radiance, Strength::power, Strength::nits,
                                     Strength::lumens};
  Declaration<EmissionParameters> d(
      {.name = "emissive",
       .doc =
           "Gives light: from the outside of solids, from the front of sheets and meshes. A "
           "combination gives it from where its operands that wear this are seen, cut faces "
           "included; 'power' and 'lumens' are spread over that area, which is measured to 0.1 %.",
       .section = materials_section,
       .examples = {"emissive { radiance = 3, temperature = 2700 }",
                    "emissive { power = 60, color = \"orange\" }"}});
  declare_emission(d, strengths);
  return node_kind(std::move(d), [](EmissionParameters&& e, const Context& context) {
    return material_node(Emissive{to_emission(e, strengths, context)}, {}, context);
  });
}

NodeKind phong() {
  using M = Detailed<Phong>;
  Declaration<M> d({.name = "phong",
                    .doc = "The plastic of early computer graphics: diffuse, with a highlight "
                           "that fades at grazing angles. For new scenes, see coated.",
                    .section = materials_section,
                    .examples = {"phong { \"#2050a0\", specular = 0.4, exponent = 80 }"}});
  d.parameter<ColorReader>("diffuse", &Phong::diffuse,
                           {.doc = "Share of the light that it gives back in all directions.",
                            .shorthand = Shorthand::yes,
                            .default_text = "{0.6, 0.6, 0.6}"})
      .parameter<ColorReader>("specular", &Phong::specular,
                              {.doc = "Share in the highlight; with 'diffuse' at most 1, what is "
                                      "beyond does not count.",
                               .default_text = "{0.3, 0.3, 0.3}"})
      .parameter<NumberReader>(
          "exponent", &Phong::exponent,
          {.doc = "How tight the highlight is.", .range = {.min = 0, .max = 1e6}});
  return node_kind(declare_detail(d), [](M&& m, const Context& context) {
    SurfaceDetail detail = std::move(m.detail);
    return material_node(Phong(std::move(m)), std::move(detail), context);
  });
}

NodeKind thin_glass() {
  using M = Detailed<ThinGlass>;
  Declaration<M> d(
      {.name = "thin_glass",
       .doc = "A window pane: both faces of a plate at once. Light goes straight through; solids "
              "that wear it are hollow. Fits sheets and open meshes, too.",
       .section = materials_section,
       .examples = {"thin_glass()", "rectangle { material = thin_glass { color = \"#c8e8d8\" } }",
                    "sphere { material = thin_glass(1.33) }"}});
  d.parameter<GlassIndexReader>(
       "ior", &ThinGlass::index,
       {.doc = fmt::format("Index of refraction, or one of: {}.", fmt::join(glass_names(), ", ")),
        .range = {.min = 1, .max = 10},
        .shorthand = Shorthand::yes})
      .parameter<ColorReader>("color", &ThinGlass::color,
                              {.doc = "What its thickness leaves of light that crosses it head on.",
                               .default_text = "1"});
  return node_kind(declare_detail(d), [](M&& m, const Context& context) {
    SurfaceDetail detail = std::move(m.detail);
    return material_node(ThinGlass(std::move(m)), std::move(detail), context);
  });
}

}  // namespace

RefractiveIndex GlassIndexReader::read(const Value& value, const Context& context) {
  if (value.kind() == ValueKind::number) {
    return RefractiveIndex::constant(schema::Reader<double>::read(value, context));
  }
  if (value.kind() != ValueKind::string) {
    schema::fail_type("an index of refraction such as 1.5 or the name of a glass", value, context);
  }
  if (auto index = find_glass(value.string())) return *std::move(index);
  fail_catalogue(glass_names(), "glass", value, context);
}

std::string GlassIndexReader::text(const RefractiveIndex& index) {
  return index.dispersive() ? "" : fmt::format("{}", index.at(589.3));
}

std::vector<NodeKind> material_kinds() {
  return {matte(), metal(), glass(), thin_glass(), phong(), emissive()};
}

}  // namespace lapidary::description
