#include "texture/cells.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "texture/box_filter.h"
#include "texture/lattice.h"

namespace lapidary::texture {
namespace {

/// Cells up to two away hold both nearest points: of the eight cells about the nearest corner, at
/// least two have points less than 2 away unless they are all at their far ends.
constexpr int reach = 2;

/// In [0, 1).
double unit(std::uint32_t bits) {
  return static_cast<double>(bits) * 0x1p-32;
}

/// Squares of the distances to cells by how far they are along one axis.
std::array<double, 2 * reach + 1> squared_gaps(double within) {
  std::array<double, 2 * reach + 1> squared{};
  for (int i = -reach; i <= reach; ++i) {
    const double gap = i < 0 ? within - (i + 1) : i > 0 ? i - within : 0.0;
    squared[static_cast<std::size_t>(i + reach)] = gap * gap;
  }
  return squared;
}

/// The two nearest so far; distances are squares.
struct Search {
  LatticePoint at;
  double scatter;
  std::uint32_t seed;
  NearPoints found{.first = infinity, .second = infinity};

  void look(int i, int j, int k) {
    const auto [x, y, z] = at.cell;
    const auto part = [](int step) { return static_cast<std::uint32_t>(step); };
    const std::uint32_t bits = lattice_hash(x + part(i), y + part(j), z + part(k), seed);
    const auto place = [&](int step, std::uint32_t salt) {
      return step + 0.5 + scatter * (unit(lattice_hash(bits, salt, 0, seed)) - 0.5);
    };
    const Vec3d point{place(i, 1), place(j, 2), place(k, 3)};
    const double squared = length_squared(point - at.within);
    if (squared < found.first) {
      found.second = found.first;
      found.first = squared;
      found.nearest = bits;
    } else if (squared < found.second) {
      found.second = squared;
    }
  }
};

}  // namespace

NearPoints near_points(Vec3d p, double scatter, std::uint32_t seed) {
  Search search{lattice_point(p), scatter, seed};
  const auto gx = squared_gaps(search.at.within.x), gy = squared_gaps(search.at.within.y),
             gz = squared_gaps(search.at.within.z);
  // From the middle outwards, so that most of the others are too far away to be looked at.
  constexpr std::array<int, 2 * reach + 1> order{0, -1, 1, -2, 2};
  for (const int k : order) {
    for (const int j : order) {
      for (const int i : order) {
        const double gap = gx[static_cast<std::size_t>(i + reach)] +
                           gy[static_cast<std::size_t>(j + reach)] +
                           gz[static_cast<std::size_t>(k + reach)];
        if (gap < search.found.second) search.look(i, j, k);
      }
    }
  }
  search.found.first = std::sqrt(search.found.first);
  search.found.second = std::sqrt(search.found.second);
  return search.found;
}

double pattern(const Voronoi& voronoi, const Place& place) {
  using Feature = Voronoi::Feature;
  // What is seen from so far that cells cannot be told apart, measured with points anywhere.
  constexpr double means[] = {0.5, 0.7, 0.2, 0.5};
  const double left = std::exp(-0.5 * std::pow(mean_width(place), 2));
  const double mean = means[static_cast<std::size_t>(voronoi.feature)];
  if (left < 1e-3) return mean;
  const NearPoints near = near_points(place.p, voronoi.scatter, voronoi.seed);
  const double here = voronoi.feature == Feature::f1      ? near.first
                      : voronoi.feature == Feature::f2    ? near.second
                      : voronoi.feature == Feature::edges ? near.second - near.first
                                                          : unit(near.nearest);
  return mean + left * (here - mean);
}

}  // namespace lapidary::texture
