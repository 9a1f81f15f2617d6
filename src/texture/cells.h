#pragma once

#include <cstdint>

#include "texture/pattern.h"

namespace lapidary::texture {

/// What a place knows of points scattered one to a cube of side 1.
/// Source: Worley 1996, "A Cellular Texture Basis Function", with one point in each cell.
struct NearPoints {
  double first = 0;         ///< distance to the nearest
  double second = 0;        ///< and to the one after
  std::uint32_t nearest{};  ///< random bits of the nearest
};

/// `scatter` from 0, all in the middle of their cubes, to 1, anywhere in them.
NearPoints near_points(Vec3d p, double scatter, std::uint32_t seed);

/// Cells about scattered points.
struct Voronoi {
  enum class Feature : std::uint8_t {
    f1,     ///< the distance to the nearest point
    f2,     ///< to the second
    edges,  ///< their difference: 0 on the boundaries between cells
    cells,  ///< a number for each cell, in [0, 1)
  };
  Ramp colors;
  Feature feature = Feature::f1;
  double scatter = 1;
  std::uint32_t seed = 0;
  Mapping mapping;
};

double pattern(const Voronoi& voronoi, const Place& place);

}  // namespace lapidary::texture
