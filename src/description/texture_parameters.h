#pragma once

#include <memory>
#include <string>
#include <utility>

#include "description/texture_readers.h"
#include "schema/node_kind.h"
#include "texture/texture.h"

namespace lapidary::schema {

template <>
struct EnumNames<texture::Projection> {
  static constexpr std::array<std::pair<std::string_view, texture::Projection>, 6> names{
      {{"uv", texture::Projection::uv},
       {"object", texture::Projection::object},
       {"planar", texture::Projection::planar},
       {"cylindrical", texture::Projection::cylindrical},
       {"spherical", texture::Projection::spherical},
       {"box", texture::Projection::box}}};
};

}  // namespace lapidary::schema

namespace lapidary::description {

/// Adds the parameters of T::mapping.
template <typename T>
schema::Declaration<T>& declare_mapping(schema::Declaration<T>& declaration) {
  return declaration
      .parameter(
          "mapping", [](T & t) -> auto& { return t.mapping.projection; },
          {.doc = "How it comes to lie on an object: in the surface's own coordinates, in "
                  "the space in which the object was written, or projected from there: along "
                  "z, around the z axis, around the origin, or onto the sides of a box."})
      .parameter("blend", [](T & t) -> auto& { return t.mapping.blend; },
                 {.doc = "With mapping \"box\": how soon one side shows beside another.",
                  .range = schema::unit_interval})
      .parameter(
          "repeats", [](T & t) -> auto& { return t.mapping.repeats; },
          {.doc = "With any mapping but \"object\": how often it comes in a unit of u and of "
                  "v. Around an axis or a point whole numbers have no seam."})
      .parameter("shift", [](T & t) -> auto& { return t.mapping.shift; },
                 {.doc = "With any mapping but \"object\": where in (u, v) its origin lies."});
}

/// Fails for what a mapping has no use for.
inline void check_mapping(const texture::Mapping& mapping, const schema::Context& context) {
  const Vec2d times = mapping.repeats;
  if (times.x == 0.0 || times.y == 0.0) context.at("repeats").fail("must not be zero");
  if (mapping.projection != texture::Projection::object) return;
  for (const auto& [name, is_given] :
       {std::pair("repeats", times.x != 1.0 || times.y != 1.0),
        std::pair("shift", mapping.shift.x != 0.0 || mapping.shift.y != 0.0)}) {
    if (is_given) {
      context.at(name).fail("needs a mapping that lays the pattern flat",
                            "in space, 'scale' and 'translate' a texture: texture:scale(0.5)");
    }
  }
}

/// Adds T::colors of a pattern that usually has those that `usually` says.
template <typename T>
schema::Declaration<T>& declare_colors(schema::Declaration<T>& declaration, std::string usually) {
  return declaration.template parameter<RampReader>(
      "colors", &T::colors,
      {.doc = "From 0 to 1; " + std::move(usually) + " when left out.",
       .shorthand = schema::Shorthand::yes});
}

/// Adds a seed, which `member` leads to.
template <typename T, typename Member>
schema::Declaration<T>& declare_seed(schema::Declaration<T>& declaration, Member member) {
  return declaration.parameter(
      "seed", member,
      {.doc = "Another number, another pattern of the kind.", .range = schema::non_negative});
}

/// Textures made of more than this are refused: they would take for ever to look at.
inline constexpr texture::Extent most_of_a_texture{.depth = 100, .looks = 10000};

/// Throws Error for a texture that is made of too many.
void check_extent(const texture::Texture& texture, const Location& where);

/// A finished texture as a node; `bytes` is what it holds besides itself.
template <typename Kind>
schema::Node texture_node(Kind kind, const schema::Context& context, std::size_t bytes = 0) {
  if constexpr (requires { kind.mapping; }) check_mapping(kind.mapping, context);
  auto texture = std::make_shared<const texture::Texture>(std::move(kind));
  check_extent(*texture, context.call().where.location());
  return schema::Node::of<texture::Texture>(context.call().node, std::move(texture),
                                            sizeof(texture::Texture) + bytes);
}

/// The kind of node that `declaration` declares.
template <typename Kind>
schema::NodeKind texture_kind(schema::Declaration<Kind> declaration) {
  return node_kind(std::move(declaration), [](Kind&& kind, const schema::Context& context) {
    return texture_node(std::move(kind), context);
  });
}

}  // namespace lapidary::description
