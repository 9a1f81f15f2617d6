#pragma once

#include <optional>
#include <vector>

#include "math/vec.h"
#include "sampling/distribution.h"

namespace lapidary::light {

/// The luminous intensity of a lamp by direction, as it is measured: photometry of type C.
///
/// Directions are local: z is the lamp's axis, where the vertical angle is 0; it grows to 180
/// degrees at -z. The horizontal angle grows from x towards -y: counter-clockwise as seen from
/// above, for a lamp whose axis is down. Between the angles of the table the intensity is linear in
/// both, beyond its vertical angles there is none.
class PhotometricWeb {
 public:
  /// Angles in degrees, strictly ascending. What of the circle the horizontal ones leave out
  /// follows by symmetry, as the standard has it: one angle, 0: the same all around; 0 to 90: the
  /// same in all quadrants; 0 to 180 and 90 to 270: mirrored; 0 to 360: all of it.
  struct Table {
    std::vector<double> vertical;    ///< at least two, in [0, 180]
    std::vector<double> horizontal;  ///< from and to one of the above
    std::vector<float> candela;      ///< for each horizontal angle all vertical ones; >= 0
  };

  /// Not all of the table is zero.
  explicit PhotometricWeb(const Table& table);

  /// In candela, towards a unit vector.
  double intensity(Vec3d direction) const;
  /// The integral of the intensity over all directions, in lumens; exact.
  double flux() const { return flux_; }
  /// Cosine of the vertical angle that no light is beyond.
  double least_cosine() const;

  struct Sample {
    Vec3d direction;
    double pdf = 0;
  };
  /// A direction with a density that is about as the intensity, and is nowhere zero where that is
  /// not: constant on each cell of the table.
  Sample sample(Vec2d u) const;
  /// Per solid angle, of a unit vector.
  double pdf(Vec3d direction) const;

 private:
  struct Place {
    std::size_t column = 0, row = 0;  ///< of a cell
    double across = 0, down = 0;      ///< in it, in [0, 1]
  };
  std::optional<Place> place_of(Vec3d direction) const;
  double at_corner(std::size_t column, std::size_t row) const {
    return candela_[column * vertical_.size() + row];
  }
  double flux_of_cell(std::size_t column, std::size_t row) const;
  double solid_angle(std::size_t column, std::size_t row) const;

  std::vector<double> vertical_;    // radians
  std::vector<double> horizontal_;  // radians, a whole circle
  std::vector<float> candela_;
  double flux_ = 0;
  std::optional<DiscreteDistribution> columns_;
  std::vector<DiscreteDistribution> rows_;  // of each column
};

}  // namespace lapidary::light
