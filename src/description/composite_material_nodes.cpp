#include <initializer_list>

#include <fmt/core.h>

#include "base/error.h"
#include "description/material_node.h"
#include "description/node_readers.h"
#include "description/nodes.h"
#include "description/surface_detail.h"
#include "description/texture_readers.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Shorthand;
using schema::Value;
using schema::ValueKind;

/// The surface of a material that is part of another one.
bsdf::FinishPtr part(const MaterialPtr& material, const Context& context) {
  if (emission_of(*material) != nullptr) {
    context.fail("cannot be made of what gives light",
                 "let a body of its own glow, inside or beside this one");
  }
  if (material->detail.has_gaps() || material->detail.has_relief()) {
    context.fail("cannot be made of what has 'opacity', 'bump' or 'normal'",
                 "it takes them itself, for all that it is made of");
  }
  return std::make_shared<const bsdf::Finish>(finish_of(*material));
}

bsdf::FinishPtr opaque_part(const MaterialPtr& material, const Context& context) {
  if (as_glass(*material) != nullptr) {
    context.fail("needs an opaque base", "glass has a coat of its own: its surface");
  }
  return part(material, context);
}

/// `Material::parts` of one that is made of these.
int parts_with(std::initializer_list<MaterialPtr> materials, const Context& context) {
  int parts = 1;
  for (const MaterialPtr& material : materials) parts += material ? material->parts : 0;
  if (parts <= most_of_a_material) return parts;
  throw Error(context.call().where.location(),
              fmt::format("a material is made of more than {} others", most_of_a_material),
              "each of them is looked at for every point of a picture");
}

struct VelvetParameters : Velvet {
  MaterialPtr ground;
};

NodeKind velvet() {
  using V = Detailed<VelvetParameters>;
  Declaration<V> d(
      {.name = "velvet",
       .doc = "Cloth with a pile, felt, dust: fine fibres that glow where the surface "
              "turns away, over a ground of the same color or any opaque material.",
       .section = materials_section,
       .examples = {"velvet \"#7a1020\"", "velvet { color = 0.6, base = metal \"copper\" }"}});
  d.parameter<ColorReader>(
       "color", &V::color,
       {.doc = "Of the fibres.", .shorthand = Shorthand::yes, .default_text = "{0.8, 0.8, 0.8}"})
      .parameter<NumberReader>("roughness", &V::roughness,
                               {.doc = "0 are fibres that stand up, which glow at the rim alone; "
                                       "1 is felt.",
                                .range = schema::unit_interval})
      .parameter("base", &V::ground,
                 {.doc = "What is under the fibres; a matte ground of their color when left out."});
  return node_kind(declare_detail(d), [](V&& v, const Context& context) {
    const int parts = parts_with({v.ground}, context);
    if (v.ground) v.base = opaque_part(v.ground, context);
    SurfaceDetail detail = std::move(v.detail);
    return material_node(Velvet(std::move(v)), std::move(detail), context, parts);
  });
}

struct CoatedParameters : Coated {
  MaterialPtr below;
};

NodeKind coated() {
  using C = Detailed<CoatedParameters>;
  Declaration<C> d(
      {.name = "coated",
       .doc = "A layer of varnish, glaze or water over any opaque material, which is darker and "
              "more saturated below it.",
       .section = materials_section,
       .examples = {"coated(matte \"#204080\")",
                    "coated { metal { \"copper\", roughness = 0.3 }, color = \"#ff9060\" }",
                    "coated { base = matte \"sienna\", ior = 1.33, roughness = 0.2 }"}});
  d.parameter(
       "base", &C::below,
       {.doc = "What it covers.", .need = schema::Need::required, .shorthand = Shorthand::yes})
      .parameter("ior", &C::index,
                 {.doc = "Its index of refraction, relative to what is around.",
                  .range = {.min = 1, .max = 3}})
      .parameter<NumberReader>("roughness", &C::roughness,
                               {.doc = roughness_doc, .range = schema::unit_interval});
  declare_brushing(
      d, "", [](C & c) -> auto& { return c.brushing; });
  d.parameter<ColorReader>("color", &C::color,
                           {.doc = "What it leaves of light that goes down and up again head "
                                   "on.",
                            .default_text = "1"});
  return node_kind(declare_detail(d), [](C&& c, const Context& context) {
    const int parts = parts_with({c.below}, context);
    c.base = opaque_part(c.below, context);
    SurfaceDetail detail = std::move(c.detail);
    return material_node(Coated(std::move(c)), std::move(detail), context, parts);
  });
}

using MaterialPair = std::array<MaterialPtr, 2>;

struct MaterialPairReader {
  static std::string type() { return "list of two materials"; }
  static MaterialPair read(const Value& value, const Context& context) {
    const bool pair = value.kind() == ValueKind::table && value.table().items.size() == 2 &&
                      value.table().fields.empty();
    if (!pair) schema::fail_type("a list of two materials", value, context);
    const auto items = value.table().items;
    using Reader = schema::Reader<MaterialPtr>;
    return {Reader::read(items[0], context.at(0)), Reader::read(items[1], context.at(1))};
  }
  static std::string text(const MaterialPair&) { return ""; }
};

struct BlendParameters : bsdf::Blend {
  MaterialPair of;
};

/// The glass that fills a body of both; fails where each has its own.
std::optional<Glass> common_filling(const MaterialPair& of, const Context& context) {
  const bool thin = is_thin(*of[0]) || is_thin(*of[1]);
  const Glass *a = as_glass(*of[0]), *b = as_glass(*of[1]);
  if (a && b && !thin) {
    context.fail("cannot blend two kinds of glass", "vary the roughness of one instead");
  }
  if (!a && !b) return std::nullopt;
  return !b || (a && !is_thin(*of[0])) ? *a : *b;
}

NodeKind blend() {
  using B = Detailed<BlendParameters>;
  Declaration<B> d(
      {.name = "blend",
       .doc = "Two materials in patches too fine to see; with a texture for 'weight', patches that "
              "one does see.",
       .section = materials_section,
       .examples = {
           "blend { metal \"gold\", matte \"#402010\" }",
           "blend { materials = { glass(1.5), matte \"white\" }, weight = checker { 0, 1 } }"}});
  d.parameter<MaterialPairReader>(
       "materials", &B::of,
       {.doc = "One may be glass.", .need = schema::Need::required, .shorthand = Shorthand::yes})
      .parameter<NumberReader>("weight", &B::weight,
                               {.doc = "Share of the second; the rest is of the first.",
                                .range = schema::unit_interval});
  return node_kind(declare_detail(d), [](B&& b, const Context& context) {
    const int parts = parts_with({b.of[0], b.of[1]}, context);
    Blend blend{b, common_filling(b.of, context)};
    blend.first = part(b.of[0], context);
    blend.second = part(b.of[1], context);
    return material_node(std::move(blend), std::move(b.detail), context, parts);
  });
}

}  // namespace

std::vector<NodeKind> composite_material_kinds() {
  return {coated(), velvet(), blend(), principled_kind()};
}

}  // namespace lapidary::description
