#include "transport/illumination_maps.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary::transport {
namespace {

constexpr double texels_per_radius = 3.0;
/// Texels of all maps together: more, and they get larger.
constexpr double most_texels = 1 << 24;
/// The most that may be asked for.
constexpr double most_wanted_texels = 1 << 27;

std::size_t slot_of(std::uint32_t first, std::uint32_t chart, SurfaceSide side) {
  return first + 2 * std::size_t{chart} + (side == SurfaceSide::back ? 1 : 0);
}

}  // namespace

/// Photons in their charts, sorted by slot; those of a slot in the order they came.
struct IlluminationMaps::Arrivals {
  std::vector<ChartPhoton> photons;
  std::vector<std::size_t> first;  ///< of each slot, and the end

  std::span<const ChartPhoton> of(std::size_t slot) const {
    return std::span(photons).subspan(first[slot], first[slot + 1] - first[slot]);
  }
};

IlluminationMaps::IlluminationMaps(const scene::Scene& scene, const Settings& settings,
                                   ThreadPool& pool)
    : scene_(scene) {
  const auto photons = trace_photons(scene, settings.budget, pool, counters_);
  if (!photons) {
    state_ = State::no_light;
    return;
  }
  find_surfaces(*photons);
  const Arrivals arrivals = sorted(*photons);
  std::vector<ChartPlan> plans = plan(arrivals);
  if (plans.empty()) {
    state_ = State::nothing_arrives;
    return;
  }
  radius_ = settings.radius.value_or(radius_by_density(plans, scene.size()));
  set_grids(plans, settings);
  make_maps(plans, {settings.filter, radius_}, pool);
}

void IlluminationMaps::find_surfaces(const std::vector<FallenPhoton>& photons) {
  using Found = std::pair<SurfaceKey, std::uint32_t>;  // with the object that wears it
  std::vector<Found> found;
  for (const FallenPhoton& photon : photons) {
    // Many fall where the one before fell.
    if (!found.empty() && found.back().first == photon.place.key) continue;
    found.emplace_back(photon.place.key, photon.object);
  }
  const auto is_less = [](const Found& a, const Found& b) { return a.first < b.first; };
  const auto is_same = [](const Found& a, const Found& b) { return a.first == b.first; };
  std::stable_sort(found.begin(), found.end(), is_less);
  found.erase(std::unique(found.begin(), found.end(), is_same), found.end());
  std::map<const geometry::TriangleMesh*, MappedSurface::Meshes> meshes;  // only looked up
  std::uint32_t slots = 0;
  for (const auto& [key, object] : found) {
    MappedSurface::Meshes charts;
    if (const geometry::TriangleMesh* mesh = MappedSurface::mesh_of(scene_.world(), key)) {
      MappedSurface::Meshes& shared = meshes[mesh];
      if (!shared) {
        shared = std::make_shared<const geometry::MeshCharts>(geometry::mesh_charts(*mesh));
      }
      charts = shared;
    }
    surfaces_.emplace_back(scene_.world(), key, std::move(charts));
    objects_.push_back(object);
    first_slot_.push_back(slots);
    slots += 2 * static_cast<std::uint32_t>(surfaces_.back().chart_count());
  }
  entry_of_.assign(slots, no_entry);
}

std::size_t IlluminationMaps::surface_of(const SurfaceKey& key) const {
  const auto found = std::lower_bound(
      surfaces_.begin(), surfaces_.end(), key,
      [](const MappedSurface& surface, const SurfaceKey& k) { return surface.key() < k; });
  const bool is_known = found != surfaces_.end() && found->key() == key;
  return is_known ? static_cast<std::size_t>(found - surfaces_.begin()) : surfaces_.size();
}

IlluminationMaps::Arrivals IlluminationMaps::sorted(
    const std::vector<FallenPhoton>& photons) const {
  constexpr std::uint32_t nowhere = ~0u;
  std::vector<std::uint32_t> slots(photons.size(), nowhere);
  std::vector<Vec2d> at(photons.size());
  Arrivals arrivals;
  arrivals.first.assign(entry_of_.size() + 1, 0);
  for (std::size_t i = 0; i < photons.size(); ++i) {
    const std::size_t surface = surface_of(photons[i].place.key);
    const auto point = surfaces_[surface].locate(photons[i].place);
    if (!point) continue;
    at[i] = point->at;
    slots[i] =
        static_cast<std::uint32_t>(slot_of(first_slot_[surface], point->chart, photons[i].side));
    ++arrivals.first[slots[i] + 1];
  }
  for (std::size_t s = 1; s < arrivals.first.size(); ++s) {
    arrivals.first[s] += arrivals.first[s - 1];
  }
  arrivals.photons.resize(arrivals.first.back());
  std::vector<std::size_t> next(arrivals.first.begin(), arrivals.first.end() - 1);
  for (std::size_t i = 0; i < photons.size(); ++i) {
    if (slots[i] != nowhere) arrivals.photons[next[slots[i]]++] = {at[i], photons[i].power};
  }
  return arrivals;
}

std::vector<ChartPlan> IlluminationMaps::plan(const Arrivals& arrivals) const {
  std::vector<ChartPlan> plans;
  for (std::uint32_t s = 0; s < surfaces_.size(); ++s) {
    for (std::uint32_t chart = 0; chart < surfaces_[s].chart_count(); ++chart) {
      const std::size_t front = slot_of(first_slot_[s], chart, SurfaceSide::front);
      const auto of_front = arrivals.of(front), of_back = arrivals.of(front + 1);
      if (of_front.empty() && of_back.empty()) continue;
      plans.push_back(plan_of(surfaces_[s], chart, {of_front, of_back}));
      plans.back().surface = s;
    }
  }
  return plans;
}

void IlluminationMaps::set_grids(std::vector<ChartPlan>& plans, const Settings& settings) {
  const auto texels_of = [&](double texel) {
    double sum = 0.0;
    for (ChartPlan plan : plans) {
      set_grid(surfaces_[plan.surface], texel, radius_, plan);
      sum += static_cast<double>(plan.grid.width) * plan.grid.height;
    }
    return sum;
  };
  texel_size_ = settings.resolution ? 1.0 / *settings.resolution : radius_ / texels_per_radius;
  if (settings.resolution) {
    const double texels = texels_of(texel_size_);
    if (texels > most_wanted_texels) {
      throw Error({}, fmt::format("maps of this resolution have {:.3g} texels", texels),
                  fmt::format("at most {:.3g} are possible: a resolution of about {:.3g}",
                              most_wanted_texels,
                              *settings.resolution * std::sqrt(most_wanted_texels / texels)));
    }
  } else {
    const double least = 1e-6 * scene_.size();
    texel_size_ = std::max(texel_size_, least);
    // Borders are rounded up to whole texels, so once may not be enough.
    for (double texels; (texels = texels_of(texel_size_)) > most_texels;) {
      const double ratio = std::sqrt(texels / most_texels);
      if (ratio < 1.01 || texel_size_ > scene_.size()) break;
      texel_size_ *= ratio;
    }
  }
  for (ChartPlan& plan : plans) set_grid(surfaces_[plan.surface], texel_size_, radius_, plan);
}

void IlluminationMaps::make_maps(const std::vector<ChartPlan>& plans, const Blur& how,
                                 ThreadPool& pool) {
  std::vector<std::vector<Entry>> made(plans.size());
  pool.parallel_for(plans.size(), 1, [&](IndexRange some) {
    for (std::size_t i = some.begin; i < some.end; ++i) {
      const ChartPlan& plan = plans[i];
      const TexelGround ground = surfaces_[plan.surface].ground(plan.chart, plan.grid, plan.range);
      for (const SurfaceSide side : {SurfaceSide::front, SurfaceSide::back}) {
        const auto photons = plan.sides[side == SurfaceSide::front ? 0 : 1];
        if (photons.empty()) continue;
        std::vector<SampledSpectrum> power(ground.grid.size());
        for (const ChartPhoton& photon : photons) {
          const std::ptrdiff_t texel = ground.texel_at(photon.at);
          if (texel >= 0) power[static_cast<std::size_t>(texel)] += photon.power;
        }
        made[i].push_back(
            {plan.surface, plan.chart, side, photons.size(), IlluminationMap(ground, power, how)});
      }
    }
  });
  for (std::vector<Entry>& some : made) {
    for (Entry& entry : some) {
      entry_of_[slot_of(first_slot_[entry.surface], entry.chart, entry.side)] =
          static_cast<std::uint32_t>(entries_.size());
      entries_.push_back(std::move(entry));
    }
  }
}

Rgb IlluminationMaps::irradiance(const geometry::Hit& hit, const geometry::Surface& surface,
                                 SurfaceSide side) const {
  if (entries_.empty()) return {};
  const SurfacePlace place = place_on_surface(scene_.world(), hit, surface);
  const std::size_t number = surface_of(place.key);
  if (number == surfaces_.size()) return {};
  const auto point = surfaces_[number].locate(place);
  if (!point) return {};
  const std::uint32_t entry = entry_of_[slot_of(first_slot_[number], point->chart, side)];
  return entry == no_entry ? Rgb{} : entries_[entry].map.irradiance(point->at);
}

}  // namespace lapidary::transport
