#pragma once

#include <optional>
#include <vector>

#include "math/vec.h"
#include "sampling/distribution.h"

namespace lapidary::light {

/// The luminous intensity of a lamp by direction, as it is measured.
///
/// Directions are local, z is the lamp's axis. Type C, of lamps for rooms and streets: the vertical
/// angle is 0 at z and grows to 180 degrees at -z; the horizontal one grows from x towards -y:
/// counter-clockwise as seen from above, for a lamp whose axis is down. Types A and B, of
/// headlights and floodlights, whose axis is level: both angles are 0 at z, the vertical one grows
/// towards x, which is up, and the horizontal one towards y, which is right as seen from behind the
/// lamp. One of them turns half planes about the polar axis, and the other one is taken in such a
/// plane: of type A the polar axis is x, of type B it is y.
///
/// Between the angles of the table the intensity is linear in both, beyond them there is none.
/// Source: ANSI/IESNA LM-63-2002, section 3: planes of types A and C share a vertical axis, those
/// of type B a horizontal one; horizontal angles go clockwise for types A and B, as seen from
/// above, counter-clockwise for type C; of type A the vertical angle is -90 degrees straight down.
/// A lamp of type B is looked at there as it faces down, where both angles are 0: the same lamp,
/// turned.
class PhotometricWeb {
 public:
  enum class Type { c, b, a };

  /// Angles in degrees, strictly ascending. Of type C, what of the circle the horizontal ones leave
  /// out follows by symmetry, as the standard has it: one angle, 0: the same all around; 0 to 90:
  /// the same in all quadrants; 0 to 180 and 90 to 270: mirrored; 0 to 360: all of it. Of types A
  /// and B both are in [-90, 90], and mirrored where they begin at 0.
  struct Table {
    std::vector<double> vertical;    ///< at least two, of type C in [0, 180]
    std::vector<double> horizontal;  ///< of types A and B at least two
    std::vector<float> candela;      ///< for each horizontal angle all vertical ones; >= 0
    Type type = Type::c;
  };

  /// Not all of the table is zero.
  explicit PhotometricWeb(const Table& table);

  /// In candela, towards a unit vector.
  double intensity(Vec3d direction) const;
  /// The integral of the intensity over all directions, in lumens; exact.
  double flux() const { return flux_; }
  /// Cosine of the angle to z that no light is beyond.
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
  /// A table by angles about the web's own z: as of type C, but not always of a whole circle.
  struct Grid {
    std::vector<double> polar, azimuth;  // degrees
    std::vector<float> candela;          // for each azimuth all polar angles
  };
  static Grid grid_of(const Table& table);
  Vec3d web_from_lamp(Vec3d v) const;
  Vec3d lamp_from_web(Vec3d v) const;

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

  Type type_;
  std::vector<double> vertical_;    // radians, about the web's z
  std::vector<double> horizontal_;  // radians
  std::vector<float> candela_;
  double flux_ = 0;
  std::optional<DiscreteDistribution> columns_;
  std::vector<DiscreteDistribution> rows_;  // of each column
};

}  // namespace lapidary::light
