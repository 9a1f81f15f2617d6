#pragma once

#include <array>
#include <vector>

#include "geometry/polyhedron.h"

namespace lapidary::geometry {

/// What polyhedra share. Private to polyhedron*.cpp.
struct Polyhedron::Data {
  static constexpr std::size_t lanes = 4;

  /// Four planes, as plane_crossing.h needs them; the last one is filled up with copies.
  struct alignas(32) Planes {
    std::array<std::array<double, lanes>, 3> point, normal;
    std::array<double, lanes> normal_length;  ///< |x| + |y| + |z|
  };

  /// A piece of a face.
  struct Piece {
    std::array<Vec3d, 3> corners;  ///< counter-clockwise seen from outside
    Patch patch;
  };

  /// `pieces` tile the boundary, or say nothing where the solid is unbounded.
  Data(std::vector<HalfSpace> faces, double normal_roundings, std::vector<Piece> pieces,
       const Box3d& box);

  std::vector<HalfSpace> faces;
  double normal_roundings;
  std::vector<Planes> planes;
  std::vector<Piece> pieces;
  std::vector<double> area_to;  ///< of all pieces up to this one
  double area = infinity, volume = infinity;
  Box3d box;
};

/// The boundary of an intersection, from its half-spaces alone.
struct PolyhedronFaces {
  std::vector<Polyhedron::Data::Piece> pieces;  ///< none when unbounded
  Box3d box;
  bool has_volume = false;
};
PolyhedronFaces faces_of_intersection(std::span<const HalfSpace> half_spaces);

}  // namespace lapidary::geometry
