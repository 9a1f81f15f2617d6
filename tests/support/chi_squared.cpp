#include "support/chi_squared.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

#include <fmt/format.h>

#include "math/constants.h"

namespace lapidary::test {
namespace {

// Below this expectation the chi-squared approximation of a bin is poor (Cochran 1952).
constexpr double min_expected = 5.0;

// Regularised lower incomplete gamma function by its power series; for x < a + 1.
double gamma_p_series(double a, double x) {
  double term = 1.0 / a;
  double sum = term;
  for (double n = a + 1.0; term > sum * 1e-17; n += 1.0) {
    term *= x / n;
    sum += term;
  }
  return sum * std::exp(-x + a * std::log(x) - std::lgamma(a));
}

// Regularised upper incomplete gamma function by Legendre's continued fraction, evaluated with
// Lentz's method (Lentz 1976); for x >= a + 1.
double gamma_q_fraction(double a, double x) {
  constexpr double tiny = 1e-300;
  double b = x + 1.0 - a;
  double c = 1.0 / tiny;
  double d = 1.0 / b;
  double value = d;
  for (int i = 1; i < 100000; ++i) {
    const double numerator = -i * (i - a);
    b += 2.0;
    d = numerator * d + b;
    d = 1.0 / (std::abs(d) < tiny ? tiny : d);
    c = b + numerator / c;
    c = std::abs(c) < tiny ? tiny : c;
    value *= c * d;
    if (std::abs(c * d - 1.0) < 1e-15) break;
  }
  return value * std::exp(-x + a * std::log(x) - std::lgamma(a));
}

struct Bin {
  double observed = 0.0;
  double expected = 0.0;
};

// Merges bins, smallest expectation first, until each expects at least `min_expected`.
std::vector<Bin> pool(std::vector<Bin> bins) {
  std::stable_sort(bins.begin(), bins.end(),
                   [](const Bin& a, const Bin& b) { return a.expected < b.expected; });
  std::vector<Bin> pooled;
  Bin open;
  for (const Bin& bin : bins) {
    open.observed += bin.observed;
    open.expected += bin.expected;
    if (open.expected < min_expected) continue;
    pooled.push_back(open);
    open = {};
  }
  if (pooled.empty()) return {open};
  pooled.back().observed += open.observed;
  pooled.back().expected += open.expected;
  return pooled;
}

ChiSquaredResult refuse(std::string message) {
  ChiSquaredResult result;
  result.message = std::move(message);
  return result;
}

// What no statistic needs to decide; empty when nothing is wrong.
std::string find_plain_fault(std::span<const double> observed, std::span<const double> expected) {
  if (observed.size() != expected.size()) return "observed and expected differ in size";
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (!(expected[i] >= 0.0) || !std::isfinite(expected[i]))
      return fmt::format("bin {} expects {}", i, expected[i]);
    if (expected[i] == 0.0 && observed[i] > 0.0)
      return fmt::format("bin {} has {} samples where the density is zero", i, observed[i]);
  }
  const double total = std::accumulate(observed.begin(), observed.end(), 0.0);
  const double mass = std::accumulate(expected.begin(), expected.end(), 0.0);
  if (std::abs(mass - total) > 1e-3 * total)
    return fmt::format("the density integrates to {:.6g} of the samples", mass / total);
  return "";
}

struct Cell {
  Vec2d min;
  Vec2d size;
};

double gauss_4x4(const Cell& cell, const std::function<double(Vec2d)>& f) {
  constexpr std::array<double, 4> node{0.06943184420297371239, 0.33000947820757186760,
                                       0.66999052179242813240, 0.93056815579702628761};
  constexpr std::array<double, 4> weight{0.17392742256872692869, 0.32607257743127307131,
                                         0.32607257743127307131, 0.17392742256872692869};
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      sum += weight[i] * weight[j] *
             f({cell.min.x + cell.size.x * node[i], cell.min.y + cell.size.y * node[j]});
  return sum * cell.size.x * cell.size.y;
}

double integrate(const Cell& cell, double coarse, int depth, const SamplerTest& settings,
                 const std::function<double(Vec2d)>& f) {
  const Vec2d half = cell.size * 0.5;
  std::array<Cell, 4> part;
  std::array<double, 4> value{};
  for (std::size_t i = 0; i < 4; ++i) {
    part[i] = {{cell.min.x + (i & 1 ? half.x : 0.0), cell.min.y + (i & 2 ? half.y : 0.0)}, half};
    value[i] = gauss_4x4(part[i], f);
  }
  const double fine = value[0] + value[1] + value[2] + value[3];
  const bool settled = std::abs(fine - coarse) <= 1e-8 && depth >= settings.min_depth;
  if (settled || depth >= settings.max_depth) return fine;
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) sum += integrate(part[i], value[i], depth + 1, settings, f);
  return sum;
}

// The cell of a coordinate, or nothing when it lies outside; the upper bound belongs to the last.
std::optional<std::size_t> cell_index(double x, double low, double high, int count) {
  if (!(low <= x && x <= high)) return std::nullopt;
  const double scaled = (x - low) / (high - low) * count;
  return static_cast<std::size_t>(std::min(scaled, count - 0.5));
}

}  // namespace

double chi_squared_survival(double x, double degrees_of_freedom) {
  if (!(x > 0.0)) return 1.0;
  const double a = 0.5 * degrees_of_freedom;
  const double half = 0.5 * x;
  return half < a + 1.0 ? 1.0 - gamma_p_series(a, half) : gamma_q_fraction(a, half);
}

double sidak(double significance, int tests) {
  return -std::expm1(std::log1p(-significance) / tests);
}

ChiSquaredResult chi_squared_test(std::span<const double> observed,
                                  std::span<const double> expected, double significance) {
  if (std::string fault = find_plain_fault(observed, expected); !fault.empty())
    return refuse(std::move(fault));
  std::vector<Bin> bins;
  for (std::size_t i = 0; i < expected.size(); ++i)
    if (expected[i] > 0.0) bins.push_back({observed[i], expected[i]});
  if (bins.empty()) return refuse("nothing is expected anywhere");

  const std::vector<Bin> pooled = pool(std::move(bins));
  ChiSquaredResult result;
  for (const Bin& bin : pooled)
    result.statistic +=
        (bin.observed - bin.expected) * (bin.observed - bin.expected) / bin.expected;
  result.degrees_of_freedom = static_cast<int>(pooled.size()) - 1;
  result.p_value = result.degrees_of_freedom == 0
                       ? 1.0
                       : chi_squared_survival(result.statistic, result.degrees_of_freedom);
  result.accepted = result.p_value >= significance;
  result.message = fmt::format(
      "chi^2 = {:.1f} with {} degrees of freedom, p = {:.3g}, refused "
      "below {:.3g}",
      result.statistic, result.degrees_of_freedom, result.p_value, significance);
  return result;
}

Grid sphere_grid(int cells_cos_theta, int cells_phi) {
  return {{0.0, -1.0}, {2.0 * pi, 1.0}, cells_phi, cells_cos_theta};
}

Vec3d direction_of(Vec2d phi_cos_theta) {
  const double z = phi_cos_theta.y;
  const double r = std::sqrt(std::max(0.0, (1.0 - z) * (1.0 + z)));
  return {r * std::cos(phi_cos_theta.x), r * std::sin(phi_cos_theta.x), z};
}

Vec2d phi_cos_theta_of(Vec3d direction) {
  const double phi = std::atan2(direction.y, direction.x);
  return {phi < 0.0 ? std::min(phi + 2.0 * pi, 2.0 * pi) : phi, std::clamp(direction.z, -1.0, 1.0)};
}

std::vector<double> integrate_cells(const Grid& grid, const std::function<double(Vec2d)>& density,
                                    const SamplerTest& settings) {
  const Vec2d size{(grid.max.x - grid.min.x) / grid.nx, (grid.max.y - grid.min.y) / grid.ny};
  std::vector<double> integrals;
  for (int y = 0; y < grid.ny; ++y)
    for (int x = 0; x < grid.nx; ++x) {
      const Cell cell{{grid.min.x + x * size.x, grid.min.y + y * size.y}, size};
      integrals.push_back(integrate(cell, gauss_4x4(cell, density), 1, settings, density));
    }
  return integrals;
}

ChiSquaredResult test_points(const Grid& grid,
                             const std::function<std::optional<Vec2d>(Random&)>& draw,
                             const std::function<double(Vec2d)>& density,
                             const SamplerTest& settings) {
  std::vector<double> expected = integrate_cells(grid, density, settings);
  std::vector<double> observed(expected.size() + 1, 0.0);
  Random random(settings.seed);
  for (int i = 0; i < settings.samples; ++i) {
    const std::optional<Vec2d> point = draw(random);
    if (!point) {
      observed.back() += 1.0;
      continue;
    }
    const auto x = cell_index(point->x, grid.min.x, grid.max.x, grid.nx);
    const auto y = cell_index(point->y, grid.min.y, grid.max.y, grid.ny);
    if (!x || !y) return refuse(fmt::format("({}, {}) is off the grid", point->x, point->y));
    if (!(density(*point) > 0.0))
      return refuse(fmt::format("({}, {}) was drawn with density zero", point->x, point->y));
    const std::size_t cell = *y * static_cast<std::size_t>(grid.nx) + *x;
    observed[cell] += 1.0;
    // Quadrature can miss the sliver of a cell that a jump of the density cuts off.
    expected[cell] = std::max(expected[cell], 1e-12);
  }
  const double mass = std::accumulate(expected.begin(), expected.end(), 0.0);
  // What quadrature may be wrong by is no missing mass.
  const double missing = 1.0 - mass;
  expected.push_back(missing > 0.0 && observed.back() > 0.0 ? missing : 0.0);
  for (double& e : expected) e *= settings.samples;
  return chi_squared_test(observed, expected, sidak(settings.significance, settings.tests));
}

ChiSquaredResult test_directions(const std::function<std::optional<Vec3d>(Random&)>& draw,
                                 const std::function<double(Vec3d)>& density,
                                 const SamplerTest& settings, const Grid& grid) {
  return test_points(
      grid,
      [&](Random& random) -> std::optional<Vec2d> {
        const std::optional<Vec3d> direction = draw(random);
        if (!direction) return std::nullopt;
        return phi_cos_theta_of(*direction);
      },
      [&](Vec2d point) { return density(direction_of(point)); }, settings);
}

}  // namespace lapidary::test
