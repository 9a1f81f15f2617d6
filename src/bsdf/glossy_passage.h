#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "bsdf/table_lookup.h"

namespace lapidary::bsdf {

/// What keeps glossy facets of white metal white below a layer that lets T through by direction.
///
/// Light of the facets between wo and wi is weighed by a(wo) a(wi), so that it is reciprocal; the
/// layer and the facets lose nothing where for each wo the mean of a(wo) a(wi) over the light that
/// the facets send there is T(wo). For a mirror a is the root of T, for a diffuse base T over the
/// root of its mean. Between these it is T over the root of T a little further up, which is about
/// what the facets see, times a factor near one, which symmetric scaling finds on a few cosines to
/// the normal. Source: Knight, Ruiz & Ucar 2014, "A Symmetry Preserving Algorithm for Matrix
/// Scaling".
class GlossyPassage {
 public:
  static constexpr std::size_t size = 8;

  /// `alpha` in (0, 1] of the facets; `let_through` is T by the cosine, in (0, 1] above 0.
  template <typename LetThrough>
  GlossyPassage(double alpha, LetThrough let_through) : alpha_(alpha) {
    Values t, seen;
    for (std::size_t i = 0; i < size; ++i) {
      // The first stands for directions up to the next one, of which a third is the mean.
      const double mu = i > 0 ? cosine(i, alpha_) : cosine(1, alpha_) / 3.0;
      t[i] = static_cast<float>(let_through(mu));
      seen[i] = static_cast<float>(let_through(further_up(mu, alpha_)));
    }
    solve(t, seen);
  }

  /// a over T; `mu` in [0, 1], and the same T.
  template <typename LetThrough>
  double share(double mu, LetThrough let_through) const {
    const TablePlace place = table_place(cosine_coordinate(mu, scale(alpha_)), size);
    const double factor = between(factor_[place.index], factor_[place.index + 1], place.fraction);
    return factor / std::sqrt(let_through(further_up(mu, alpha_)));
  }

  /// The cosine of which T is about the mean over light of the facets towards `mu`.
  static double further_up(double mu, double alpha) {
    return std::sqrt((mu * mu + alpha * alpha) / (1.0 + alpha * alpha));
  }

  /// Cosines lie as close as facets of this alpha ask for: layers have a scale of their own, too.
  static double scale(double alpha) { return std::max(alpha, 0.02); }
  /// Of an entry, with facets of `alpha`.
  static double cosine(std::size_t i, double alpha) {
    const double x = static_cast<double>(i) / (size - 1), s = scale(alpha);
    return x * s / (1.0 + s - x);
  }

 private:
  using Values = std::array<float, size>;
  void solve(const Values& t, const Values& seen);

  double alpha_;
  Values factor_;
};

/// Where light from the cosine of a column leaves, as weights of the cosines of the rows: of white
/// metal, all bounces between its facets included. By `roughness_coordinate`, evenly from 0 to 1.
/// Made by tools/glossy_lobe.cpp.
inline constexpr std::size_t glossy_lobe_roughnesses = 16;
using GlossyLobe = std::array<std::array<float, GlossyPassage::size>, GlossyPassage::size>;
extern const std::array<GlossyLobe, glossy_lobe_roughnesses> glossy_lobe_table;

}  // namespace lapidary::bsdf
