#pragma once

#include <array>
#include <span>
#include <vector>

#include "transport/illumination_surface.h"

namespace lapidary::transport {

/// A photon in its chart.
struct ChartPhoton {
  Vec2d at;
  SampledSpectrum power;  ///< as FallenPhoton's
};

/// A chart that photons fell on, before it has its maps.
struct ChartPlan {
  std::uint32_t surface = 0, chart = 0;
  std::array<std::span<const ChartPhoton>, 2> sides;
  MappedSurface::Range range;  ///< of the maps; where the chart's is infinite, that of the photons
  Vec2d lengths;               ///< the greatest lengths of the surface per unit of the coordinates
  double area = 0;             ///< in the mean, of a square unit of them
  TexelGrid grid;

  std::size_t photons() const { return sides[0].size() + sides[1].size(); }
};

/// All but the grid's size. All charts of a mesh count as stretched alike, so that their texels fit
/// into one image.
ChartPlan plan_of(const MappedSurface& surface, std::uint32_t chart,
                  std::array<std::span<const ChartPhoton>, 2> sides);

/// The radius within which about 1500 photons fell, where the photon in the middle of all did,
/// ordered by how densely they fell; at most a quarter of `size` [scene units].
double radius_by_density(std::span<const ChartPlan> plans, double size);

/// Texels of about `texel` scene units; planar charts grow by `radius` for what is blurred over
/// their edge. Of a mesh texels of all charts lie on one lattice of its coordinates.
void set_grid(const MappedSurface& surface, double texel, double radius, ChartPlan& plan);

}  // namespace lapidary::transport
