#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "math/vec.h"
#include "support/random.h"

namespace lapidary::test {

/// Outcome of a chi-squared test of goodness of fit.
struct ChiSquaredResult {
  bool accepted = false;
  double p_value = 0.0;  ///< chance that a correct sampler fits this badly or worse
  double statistic = 0.0;
  int degrees_of_freedom = 0;
  std::string message;  ///< why it was refused, or the numbers
};

/// Pearson's test: do the counts `observed` follow the counts `expected`?
///
/// Bins are pooled, smallest expectation first, until every pool expects at least 5, as the
/// chi-squared approximation needs. Refused outright: a count in a bin that expects exactly
/// nothing; totals that differ by more than 1e-3 relative, since a density that does not
/// integrate to one is wrong whatever its shape; negative or non-finite expectations.
/// A correct sampler is refused with probability `significance` (the false-alarm rate).
ChiSquaredResult chi_squared_test(std::span<const double> observed,
                                  std::span<const double> expected, double significance);

/// The significance of each of `tests` independent tests that together have the false-alarm rate
/// `significance`. Source: Sidak 1967.
double sidak(double significance, int tests);

/// P(X > x) for X chi-squared distributed. Accuracy: about 1e-12 relative.
double chi_squared_survival(double x, double degrees_of_freedom);

/// A grid of nx times ny equal cells over the rectangle [min, max].
struct Grid {
  Vec2d min{0, 0};
  Vec2d max{1, 1};
  int nx = 20;
  int ny = 20;
};

/// The sphere of directions as a rectangle of equal areas: x = phi in [0, 2 pi) about +z,
/// y = cos theta. An area of the rectangle is a solid angle.
Grid sphere_grid(int cells_cos_theta = 20, int cells_phi = 40);
Vec3d direction_of(Vec2d phi_cos_theta);
Vec2d phi_cos_theta_of(Vec3d direction);

/// How a sampler is compared with its density.
struct SamplerTest {
  int samples = 200000;
  double significance = 1e-4;  ///< the false-alarm rate of this one test
  std::uint64_t seed = 1;
  int tests = 1;  ///< how many such tests share `significance` (Sidak's correction)
  /// Quadrature halves each cell at least this often: raise it for densities narrower than a cell.
  int min_depth = 1;
  int max_depth = 9;
};

/// Integral of `density` over each cell, row by row of y. Adaptive; absolute error per cell about
/// 1e-8 for smooth densities, up to a thousandth of the cell's integral where a jump cuts it.
std::vector<double> integrate_cells(const Grid& grid, const std::function<double(Vec2d)>& density,
                                    const SamplerTest& settings = {});

/// Draws points and compares their counts per cell with the density's integrals. A draw may give
/// nothing, with the probability that the density lacks to one. Refused outright: points off the
/// grid, and points drawn where the density is not positive.
ChiSquaredResult test_points(const Grid& grid,
                             const std::function<std::optional<Vec2d>(Random&)>& draw,
                             const std::function<double(Vec2d)>& density,
                             const SamplerTest& settings = {});

/// The same for unit directions and a density per solid angle.
ChiSquaredResult test_directions(const std::function<std::optional<Vec3d>(Random&)>& draw,
                                 const std::function<double(Vec3d)>& density,
                                 const SamplerTest& settings = {},
                                 const Grid& grid = sphere_grid());

}  // namespace lapidary::test
