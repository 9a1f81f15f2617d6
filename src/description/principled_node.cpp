#include "description/color_readers.h"
#include "description/material_node.h"
#include "description/nodes.h"
#include "description/surface_detail.h"
#include "description/texture_readers.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Shorthand;

struct PrincipledParameters : bsdf::Principled {
  std::optional<Spectrum> transmission_color;
  std::optional<double> transmission_depth;
  std::optional<Spectrum> emission;
};

using P = Detailed<PrincipledParameters>;

Principled to_principled(P&& p, const Context& context) {
  if (p.transmission_color.has_value() != p.transmission_depth.has_value()) {
    context.fail("needs both 'transmission_color' and 'transmission_depth'",
                 "light has that color after that way through the body");
  }
  Principled principled{std::move(p), std::nullopt, std::nullopt};
  const double* transmission = principled.transmission.constant();
  const bool clear = transmission == nullptr || *transmission > 0.0;
  if (clear) {
    Glass& filling = principled.filling.emplace();
    filling.index = RefractiveIndex::constant(principled.index);
    if (p.transmission_color) {
      filling.absorption = Absorption{*std::move(p.transmission_color), *p.transmission_depth};
    }
  }
  if (p.emission) principled.emission = Emission{Quantity::radiance, *std::move(p.emission)};
  return principled;
}

void declare_base(Declaration<P>& d) {
  d.parameter<ColorReader>("color", &P::color,
                           {.doc = "base_weight times base_color: of the diffuse base, and of "
                                   "metal head on.",
                            .shorthand = Shorthand::yes,
                            .default_text = "{0.8, 0.8, 0.8}"})
      .parameter<NumberReader>("diffuse_roughness", &P::diffuse_roughness,
                               {.doc = "base_diffuse_roughness.", .range = schema::unit_interval})
      .parameter<NumberReader>(
          "metalness", &P::metalness,
          {.doc = "base_metalness: 0 is plastic, 1 is metal.", .range = schema::unit_interval})
      .parameter<NumberReader>(
          "specular", &P::specular,
          {.doc = "specular_weight, at most 1.", .range = schema::unit_interval})
      .parameter<ColorReader>("specular_color", &P::specular_color,
                              {.doc = "specular_color: of the highlight, and of metal near its "
                                      "silhouette.",
                               .default_text = "1"})
      .parameter<NumberReader>("roughness", &P::roughness,
                               {.doc = "specular_roughness.", .range = schema::unit_interval})
      .parameter("ior", &P::index, {.doc = "specular_ior.", .range = {.min = 1, .max = 3}});
  declare_brushing(
      d, "", [](P & p) -> auto& { return p.brushing; });
}

void declare_transmission(Declaration<P>& d) {
  d.parameter<NumberReader>(
       "transmission", &P::transmission,
       {.doc = "transmission_weight: 0 is opaque, 1 is glass.", .range = schema::unit_interval})
      .parameter<Optional<ReflectanceReader>>(
          "transmission_color", &P::transmission_color,
          {.doc = "transmission_color: of light after 'transmission_depth' in it."})
      .parameter(
          "transmission_depth", &P::transmission_depth,
          {.doc = "transmission_depth.", .unit = schema::Unit::length, .range = schema::positive});
}

void declare_layers(Declaration<P>& d) {
  d.parameter<NumberReader>("coat", &P::coat,
                            {.doc = "coat_weight.", .range = schema::unit_interval})
      .parameter<ColorReader>(
          "coat_color", &P::coat_color,
          {.doc = "coat_color: left of light that goes down and up again.", .default_text = "1"})
      .parameter<NumberReader>("coat_roughness", &P::coat_roughness,
                               {.doc = "coat_roughness.", .range = schema::unit_interval})
      .parameter("coat_ior", &P::coat_index, {.doc = "coat_ior.", .range = {.min = 1, .max = 3}});
  declare_brushing(
      d, "coat_", [](P & p) -> auto& { return p.coat_brushing; });
  d.parameter<NumberReader>("fuzz", &P::fuzz,
                            {.doc = "fuzz_weight.", .range = schema::unit_interval})
      .parameter<ColorReader>("fuzz_color", &P::fuzz_color,
                              {.doc = "fuzz_color.", .default_text = "1"})
      .parameter<NumberReader>("fuzz_roughness", &P::fuzz_roughness,
                               {.doc = "fuzz_roughness.", .range = schema::unit_interval})
      .parameter<Optional<LightReader>>(
          "emission", &P::emission,
          {.doc = "emission_luminance times emission_color, as the radiance of emissive.",
           .unit = schema::Unit::radiance});
}

}  // namespace

NodeKind principled_kind() {
  Declaration<P> d(
      {.name = "principled",
       .doc = "The surface that modelling programs share, as OpenPBR 1.1 has it, without "
              "subsurface and thin film. Each parameter says what it is called there.",
       .section = materials_section,
       .examples = {"principled { \"#b03020\", roughness = 0.4, coat = 1 }",
                    "principled { color = \"#e0b050\", metalness = 1, roughness = 0.25 }",
                    "principled { transmission = 1, roughness = 0, ior = 1.45 }"}});
  declare_base(d);
  declare_transmission(d);
  declare_layers(d);
  return node_kind(declare_detail(d), [](P&& p, const Context& context) {
    SurfaceDetail detail = std::move(p.detail);
    return material_node(to_principled(std::move(p), context), std::move(detail), context);
  });
}

}  // namespace lapidary::description
