#pragma once

#include <optional>
#include <vector>

#include "transport/illumination_photons.h"
#include "transport/illumination_plan.h"

namespace lapidary::transport {

/// The irradiance of all surfaces of a scene that photons fell on, as textures: one map for each
/// side of each chart that was met.
///
/// Photons are traced once, from all lights. Charts whose coordinates are lengths have a map where
/// photons fell. Everywhere else is black.
///
/// What moves carries its map along; what is cut away of it or touches it is that when the frame
/// begins. Source: Arvo 1986, "Backward Ray Tracing".
class IlluminationMaps {
 public:
  struct Settings {
    PhotonBudget budget;
    /// Of the blur [scene units]; none: `radius_by_density`.
    std::optional<double> radius;
    BlurFilter filter = BlurFilter::gaussian;
    /// Texels per scene unit; none: three to a radius, or fewer where maps would be too large.
    std::optional<double> resolution;
  };

  /// Time: that of the photons. The same bits for any number of threads. The scene must outlive
  /// this. Failure: throws Error when memory may not hold the photons, or the texels that were
  /// asked for are too many.
  IlluminationMaps(const scene::Scene& scene, const Settings& settings, ThreadPool& pool);

  /// What came of it.
  enum class State {
    active,
    no_light,         ///< there is none, or none that sends out anything
    nothing_arrives,  ///< no photon of the kind fell on anything that scatters widely
  };
  State state() const { return state_; }

  /// Of one side, at a hit of the world with its surface [W/m2], as linear Rec. 709.
  Rgb irradiance(const geometry::Hit& hit, const geometry::Surface& surface,
                 SurfaceSide side) const;

  /// One map, with what it is of.
  struct Entry {
    std::uint32_t surface = 0;  ///< of `surfaces`
    std::uint32_t chart = 0;    ///< of that
    SurfaceSide side = SurfaceSide::front;
    std::size_t photons = 0;
    IlluminationMap map;
  };
  /// By surface, chart and side.
  const std::vector<Entry>& entries() const { return entries_; }
  const std::vector<MappedSurface>& surfaces() const { return surfaces_; }

  /// The number of the scene's object that a surface is of.
  std::uint32_t object_of(std::uint32_t surface) const { return objects_[surface]; }

  double radius() const { return radius_; }          ///< of the blur [scene units]
  double texel_size() const { return texel_size_; }  ///< about [scene units]
  const Counters& counters() const { return counters_; }

 private:
  struct Arrivals;

  void find_surfaces(const std::vector<FallenPhoton>& photons);
  std::size_t surface_of(const SurfaceKey& key) const;
  Arrivals sorted(const std::vector<FallenPhoton>& photons) const;
  std::vector<ChartPlan> plan(const Arrivals& arrivals) const;
  void set_grids(std::vector<ChartPlan>& plans, const Settings& settings);
  void make_maps(const std::vector<ChartPlan>& plans, const Blur& how, ThreadPool& pool);

  static constexpr std::uint32_t no_entry = ~0u;

  const scene::Scene& scene_;
  State state_ = State::active;
  std::vector<MappedSurface> surfaces_;    ///< ascending by key
  std::vector<std::uint32_t> objects_;     ///< of surfaces
  std::vector<std::uint32_t> first_slot_;  ///< of each surface: two for each of its charts
  std::vector<std::uint32_t> entry_of_;    ///< of each slot, or no_entry
  std::vector<Entry> entries_;
  double radius_ = 0, texel_size_ = 0;
  Counters counters_;
};

}  // namespace lapidary::transport
