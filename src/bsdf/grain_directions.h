#pragma once

#include <algorithm>
#include <cmath>

#include "bsdf/ggx.h"
#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {

/// Where directions stand in tables of what facets with a grain lose or reflect, so that a few
/// entries tell all. What matters most is alpha in the plane of the direction and the normal, which
/// changes the faster the nearer that plane comes to the smoother direction.
///
/// From inside of glass there is an edge besides. Of facets as narrow as a hair all normals lie in
/// one plane, and when the part of the direction across the grain is longer than `eta`, all of them
/// reflect totally. There are as many entries on both sides of it.
class GrainDirections {
 public:
  /// Both in [0, 1]; the more `across`, the further from the rougher direction.
  struct Place {
    double across, up;
  };

  /// Of an even surface.
  GrainDirections() = default;
  /// `eta` is the index beyond over that on the side of the light; of opaque surfaces 1.
  GrainDirections(const Grain& grain, double eta) : alpha_(grain.alpha), edge_(eta) {
    const double wide = grain.wide(), narrow = grain.narrow();
    wide2_ = wide * wide;
    range2_ = wide2_ - narrow * narrow;
  }

  /// `facets` are those of the grain; v.z in [0, 1].
  Place of(const Ggx& facets, Vec3d v) const {
    const double sin2 = v.x * v.x + v.y * v.y;
    const double alpha2 = sin2 > 0.0 ? facets.stretched_sin2(v) / sin2 : wide2_;
    const double across2 = range2_ > 0.0 ? std::clamp((wide2_ - alpha2) / range2_, 0.0, 1.0) : 0.0;
    const double across = std::sqrt(across2);
    if (!has_edge()) {
      return {1.0 - std::sqrt(std::sqrt(1.0 - across)), cosine_coordinate(v.z, scale(alpha2))};
    }
    return {halves(across * std::sqrt(sin2), std::sqrt(sin2)), cosine_coordinate(v.z, alpha_)};
  }

  /// The direction at a place, of a grain that is not turned.
  Vec3d at(Place place) const {
    const double left = 1.0 - place.across;
    if (!has_edge()) {
      const double across = 1.0 - left * left * left * left;
      return direction(across, cosine_at(place.up, scale(wide2_ - range2_ * across * across)));
    }
    const double z = cosine_at(place.up, alpha_), sine = std::sqrt(1.0 - z * z);
    return direction(sine > 0.0 ? across_at(place.across, sine) / sine : 0.0, z);
  }

  bool has_edge() const { return edge_ < 1.0; }

 private:
  // Of cosines, where alpha in the plane of the direction has a square `alpha2`: what is lost
  // changes with the one, and with the facets' alpha as a whole.
  double scale(double alpha2) const { return std::sqrt(std::sqrt(alpha2) * alpha_); }
  // The inverse of cosine_coordinate.
  static double cosine_at(double t, double alpha) {
    return std::min(t * alpha / (1.0 + alpha - t), 1.0);
  }
  static Vec3d direction(double across, double z) {
    const double sine = std::sqrt(1.0 - z * z);
    return {sine * std::sqrt(1.0 - across * across), sine * across, z};
  }
  static double bent(double x) { return 1.0 - std::sqrt(std::max(1.0 - x, 0.0)); }

  /// Up to the edge, and beyond it as far as a sine goes.
  double halves(double across, double sine) const {
    const double edge = std::min(edge_, sine);
    if (across <= edge) return edge > 0.0 ? 0.5 * bent(across / edge) : 0.0;
    return 0.5 + 0.5 * bent((across - edge) / (sine - edge));
  }
  double across_at(double half, double sine) const {
    const double edge = std::min(edge_, sine);
    const double left = 1.0 - (half <= 0.5 ? 2.0 * half : 2.0 * half - 1.0);
    const double part = 1.0 - left * left;
    return half <= 0.5 ? edge * part : edge + (sine - edge) * part;
  }

  double alpha_ = 1;
  double edge_ = 1;
  double wide2_ = 1, range2_ = 0;  ///< of the square of alpha: the most, and what the least is less
};

}  // namespace lapidary::bsdf
