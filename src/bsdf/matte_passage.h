#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "bsdf/rough_diffuse.h"
#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {

/// The half sphere in a few rings around the normal, closer where layers let through less.
struct RingGrid {
  static constexpr std::size_t count = 4;
  std::array<double, count + 1> edges;  ///< cosines from 0 to 1
  std::array<double, count> weights;    ///< shares in diffuse light
  std::array<double, count> cosines;    ///< mean ones of that

  static constexpr double scale = 0.375;  ///< of edges by `cosine_coordinate`
  constexpr RingGrid() : edges{}, weights{}, cosines{} {
    for (std::size_t i = 0; i <= count; ++i) {
      const double x = static_cast<double>(i) / count;
      edges[i] = x * scale / (1.0 + scale - x);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const double a = edges[i], b = edges[i + 1];
      weights[i] = b * b - a * a;
      cosines[i] = 2.0 / 3.0 * (b * b * b - a * a * a) / weights[i];
    }
  }
};
inline constexpr RingGrid ring_grid;
// A sine is taken of it.
static_assert(ring_grid.edges[RingGrid::count] == 1.0);

/// What keeps white diffuse surfaces white below layers that let T through by direction: what
/// `GlossyPassage` is for metal.
///
/// Light of the surface between wo and wi is weighed by T s of each; nothing is lost where for each
/// wo the mean I of T s over the light that the surface sends there is 1 / s(wo). A diffuse surface
/// sends almost the same everywhere, so that the mean of T alone says how s runs: 1 / I, times the
/// root of the mean of I over the light that passes. What that leaves is of second order in how I
/// varies; with what few rings leave it is 0.004 of all light at most.
class MattePassage {
 public:
  /// T in a few rings around the normal, and its mean over diffuse light.
  struct Rings {
    std::array<float, RingGrid::count> t;
    float mean;
  };
  /// `let_through` is T by the cosine, in (0, 1]; `mean` is better known than rings could tell.
  template <typename LetThrough>
  static Rings rings(double mean, LetThrough let_through) {
    Rings rings;
    for (std::size_t i = 0; i < count; ++i)
      rings.t[i] = static_cast<float>(let_through(ring_grid.cosines[i]));
    rings.mean = static_cast<float>(mean);
    return rings;
  }
  /// Of two layers on top of each other.
  static Rings both(const Rings& a, const Rings& b);

  /// Above Lambert's law, which asks for the mean of T alone.
  explicit MattePassage(double mean);
  explicit MattePassage(const Rings& rings);
  MattePassage(const Rings& rings, const RoughDiffuse& surface);

  /// s; `mu` in [0, 1].
  double share(double mu) const {
    const TablePlace place = table_place(cosine_coordinate(mu, RingGrid::scale), size);
    return between(share_[place.index], share_[place.index + 1], place.fraction);
  }
  /// What it was made of, if rings.
  const std::optional<Rings>& rings() const { return rings_; }

 private:
  static constexpr std::size_t count = RingGrid::count, size = count + 1;
  /// `RoughDiffuse::Zones` from each ring to each edge.
  struct Zones {
    Zones();
    std::array<std::array<double, size>, count> facing;
    std::array<double, size> of_edges;
    std::array<double, count> of_rings;
  };

  std::array<float, size> share_;
  std::optional<Rings> rings_;
};

}  // namespace lapidary::bsdf
