#pragma once

#include <utility>

#include "bsdf/surface_detail.h"
#include "description/color_readers.h"
#include "description/texture_readers.h"
#include "schema/declaration.h"

namespace lapidary::description {

/// The parameters of a material with those that all materials have.
template <typename Model>
struct Detailed : Model {
  bsdf::SurfaceDetail detail;
};

/// Declares bump and normal of a `Detailed` material.
template <typename T>
schema::Declaration<T>& declare_relief(schema::Declaration<T>& d) {
  using bsdf::SurfaceDetail;
  return d
      .template parameter<Optional<NumberReader>>(
          "bump", [](T & t) -> auto& { return t.detail.bump; },
          {.doc = "Height of the surface over its shape, a texture; it tilts normals and moves "
                  "nothing.",
           .unit = schema::Unit::length})
      .template parameter<Optional<ColorReader>>(
          "normal", [](T & t) -> auto& { return t.detail.normal; },
          {.doc = "A picture of normals (tangent space, y up), as image { \"n.png\", color_space = "
                  "\"linear\" }."});
}

/// Declares everything that an opaque material has besides its own.
template <typename T>
schema::Declaration<T>& declare_detail(schema::Declaration<T>& d) {
  d.template parameter<NumberReader>(
      "opacity", [](T & t) -> auto& { return t.detail.opacity; },
      {.doc = "Share of the surface that is there; light passes through the rest.",
       .range = schema::unit_interval});
  return declare_relief(d);
}

}  // namespace lapidary::description
