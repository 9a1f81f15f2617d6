#pragma once

#include <optional>

#include "geometry/sheet.h"
#include "schema/declaration.h"

namespace lapidary::description {

/// Width and height; one number means a square.
struct Extent {
  double width = 1;
  double height = 1;
};

/// A rectangle as people say it: by its middle, size and front, or by a corner and two edges.
struct RectangleParameters {
  std::optional<Vec3d> center, normal, at;
  std::optional<Extent> size;
  std::optional<Vec3d> corner, edge_u, edge_v;
};

/// A disk; its front faces along `normal`, or towards `at`.
struct DiskParameters {
  Vec3d center;
  std::optional<Vec3d> normal, at;
  double radius = 1;
};

/// Fails through `context` when the parameters contradict each other or leave no area.
geometry::Rectangle to_rectangle(const RectangleParameters& r, const schema::Context& context);
geometry::Disk to_disk(const DiskParameters& d, const schema::Context& context);

}  // namespace lapidary::description

namespace lapidary::schema {

template <>
struct Reader<description::Extent> {
  static std::string type() { return "{width, height} or number"; }
  static description::Extent read(const Value& value, const Context& context);
  static std::string text(const description::Extent& extent);
};

}  // namespace lapidary::schema

namespace lapidary::description {

// Rectangles and disks exist as objects and as lights: T derives from their parameters.

template <typename T>
schema::Declaration<T>& declare_rectangle(schema::Declaration<T>& d) {
  using R = RectangleParameters;
  constexpr auto unit = schema::Unit::length;
  return d
      .parameter("center", &R::center,
                 {.doc = "Its middle; {0, 0, 0} when left out.", .unit = unit})
      .parameter("size", &R::size,
                 {.doc = "Its sides, the second upright where it can be; 1 by 1 when left out.",
                  .unit = unit,
                  .range = schema::positive})
      .parameter("normal", &R::normal, {.doc = "Where its front faces; up when left out."})
      .parameter("at", &R::at,
                 {.doc = "A point its front faces, instead of 'normal'.", .unit = unit})
      .parameter(
          "corner", &R::corner,
          {.doc = "A corner, with 'edge_u' and 'edge_v' instead of the above.", .unit = unit})
      .parameter("edge_u", &R::edge_u, {.doc = "One side, from the corner.", .unit = unit})
      .parameter(
          "edge_v", &R::edge_v,
          {.doc = "The other side; the front is that of cross(edge_u, edge_v).", .unit = unit});
}

template <typename T>
schema::Declaration<T>& declare_disk(schema::Declaration<T>& d) {
  using D = DiskParameters;
  return d.parameter("center", &D::center, {.doc = "Its middle.", .unit = schema::Unit::length})
      .parameter("radius", &D::radius,
                 {.doc = "Distance from the middle to the rim.",
                  .unit = schema::Unit::length,
                  .range = schema::positive})
      .parameter("normal", &D::normal, {.doc = "Where its front faces; up when left out."})
      .parameter(
          "at", &D::at,
          {.doc = "A point its front faces, instead of 'normal'.", .unit = schema::Unit::length});
}

}  // namespace lapidary::description
