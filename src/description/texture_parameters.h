#pragma once

#include <memory>
#include <utility>

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
                  .range = schema::unit_interval});
}

/// A finished texture as a node; `bytes` is what it holds besides itself.
template <typename Kind>
schema::Node texture_node(Kind kind, const schema::Context& context, std::size_t bytes = 0) {
  return schema::Node::of<texture::Texture>(
      context.call().node,
      std::make_shared<const texture::Texture>(texture::Texture{std::move(kind)}),
      sizeof(texture::Texture) + bytes);
}

}  // namespace lapidary::description
