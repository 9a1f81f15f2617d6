#include "transport/illumination_photons.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "base/memory.h"

namespace lapidary::transport {
namespace {

/// Photons traced together by one thread.
constexpr std::size_t chunk = 1024;
/// Sets of wavelengths, one of which each photon takes: well spread over any run of photons.
constexpr std::size_t wavelength_sets = 256;
constexpr std::uint32_t wavelength_dimension = 0;

void check_memory(std::uint32_t photons) {
  // Where light is reflected well each is left a few times.
  constexpr double times_left = 4.0, copies = 2.5;
  const double needed = times_left * copies * sizeof(FallenPhoton) * photons;
  const auto available = static_cast<double>(physical_memory_bytes());
  if (needed <= 0.9 * available) return;
  throw Error({},
              fmt::format("{} photons may need {:.1f} GB, and this machine has {:.1f}", photons,
                          needed / 1e9, available / 1e9),
              "fewer photons with a larger radius are as smooth");
}

/// How far from its middle photons count that fall on what is not bounded.
double reach(const scene::Scene& scene, const light::Ball& around,
             const std::vector<FallenPhoton>& photons) {
  constexpr double share = 0.8;
  if (!scene.infinite_lights().empty()) return around.radius;
  std::vector<float> distances;
  for (const FallenPhoton& photon : photons) {
    if (is_unbounded(scene.world(), photon.place.key)) distances.push_back(photon.distance);
  }
  if (distances.empty()) return around.radius;
  const auto nth = static_cast<std::ptrdiff_t>(share * static_cast<double>(distances.size() - 1));
  std::nth_element(distances.begin(), distances.begin() + nth, distances.end());
  return std::max(around.radius, static_cast<double>(distances[static_cast<std::size_t>(nth)]));
}

void leave_out_far_ones(const scene::Scene& scene, const light::Ball& around,
                        std::vector<FallenPhoton>& photons) {
  const auto most = static_cast<float>(reach(scene, around, photons));
  std::erase_if(photons, [&](const FallenPhoton& photon) {
    return photon.distance > most && is_unbounded(scene.world(), photon.place.key);
  });
}

std::vector<Wavelengths> spread_wavelengths(std::uint64_t seed) {
  const double rotation = pass_sample(seed, 0, wavelength_dimension);
  std::vector<Wavelengths> sets;
  for (std::size_t i = 0; i < wavelength_sets; ++i) {
    sets.push_back(Wavelengths::sample(Wavelengths::pass_stratum(i, rotation)));
  }
  return sets;
}

/// What one thread makes of one run of photons.
struct Yield {
  std::vector<FallenPhoton> photons;
  Counters counters;
};

std::vector<FallenPhoton> joined(std::vector<Yield>& yields, Counters& counters) {
  std::size_t size = 0;
  for (const Yield& yield : yields) size += yield.photons.size();
  std::vector<FallenPhoton> photons;
  photons.reserve(size);
  for (Yield& yield : yields) {
    photons.insert(photons.end(), yield.photons.begin(), yield.photons.end());
    yield.photons = {};
    counters += yield.counters;
  }
  counters.photons_left += size;
  return photons;
}

}  // namespace

std::optional<std::vector<FallenPhoton>> trace_photons(const scene::Scene& scene,
                                                       const PhotonBudget& budget, ThreadPool& pool,
                                                       Counters& counters) {
  check_memory(budget.photons);
  const PhotonEmitter emitter(scene, Aim::everywhere);
  if (!emitter.is_useful()) return {};
  const PhotonTracer tracer(scene, emitter, budget.max_depth, budget.light);
  const std::vector<Wavelengths> wavelengths = spread_wavelengths(budget.seed);
  const std::size_t count = budget.photons;
  const float share = 1.0f / static_cast<float>(count);

  std::vector<Yield> yields((count + chunk - 1) / chunk);
  pool.parallel_for(yields.size(), 1, [&](IndexRange some) {
    for (std::size_t y = some.begin; y < some.end; ++y) {
      Yield& mine = yields[y];
      const Wavelengths* own = nullptr;  // the photon's
      const auto leave = [&](const PhotonTracer::Arrival& at) {
        const geometry::Surface& surface = at.walk.surface();
        const bool from_front = dot(surface.geometric_normal, at.walk.ray().direction) < 0.0;
        const Rgb rgb = own->to_rgb(at.power_here() * share);
        mine.photons.push_back({place_on_surface(scene.world(), at.walk.hit(), surface),
                                {rgb.r, rgb.g, rgb.b, 0.0f},
                                scene.object_index(at.walk.hit()),
                                static_cast<float>(length(surface.p - emitter.around().center)),
                                from_front ? SurfaceSide::front : SurfaceSide::back});
      };
      const PhotonTracer::Leave leave_here = std::ref(leave);
      for (std::size_t i = y * chunk; i < std::min((y + 1) * chunk, count); ++i) {
        own = &wavelengths[i % wavelength_sets];
        tracer.trace({budget.seed, 0, static_cast<std::uint32_t>(i)}, *own, leave_here,
                     mine.counters);
      }
    }
  });
  std::vector<FallenPhoton> photons = joined(yields, counters);
  leave_out_far_ones(scene, emitter.around(), photons);
  return photons;
}

}  // namespace lapidary::transport
