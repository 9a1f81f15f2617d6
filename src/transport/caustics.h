#pragma once

#include <cstdint>

#include "base/parallel.h"
#include "transport/path.h"
#include "transport/photon_tracer.h"

namespace lapidary::transport {

/// How photons make caustics, where that should be studied; the defaults converge fastest.
struct PhotonSettings {
  /// Of a gather in the first pass, in diameters of the camera's cone there, which is a pixel's;
  /// > 0. What it blurs vanishes with its square.
  double first_radius = 2.5;
  Aim aim = Aim::casters;
};

/// Caustics by photons: what of a render does not change from pass to pass, found out in a fixed
/// first phase, and the photons of each pass. Passes are independent of one another.
///
/// Source: Hachisuka & Jensen 2009, "Stochastic Progressive Photon Mapping"; Knaus & Zwicker 2011,
/// of which the sequence of radii is (eq. 12).
class Caustics {
 public:
  struct Settings {
    CausticMethod method = CausticMethod::automatic;
    int max_depth = 16;
    std::uint64_t seed = 0;
    int width = 1, height = 1;  ///< of the picture
    PhotonSettings photons = {};
  };

  /// The scene must outlive this. Time: that of a few ten thousand paths.
  Caustics(const scene::Scene& scene, const Settings& settings, ThreadPool& pool);

  /// Why there are photons, or none.
  enum class State {
    active,
    not_wanted,       ///< the method is another
    no_caster,        ///< nothing focuses light
    no_light,         ///< of no light that there is anything reaches what could focus it
    nothing_arrives,  ///< nothing of it fell on anything that scatters widely
    not_seen,         ///< the camera sees nothing that scatters widely
  };
  State state() const { return state_; }

  /// One of the passes of a render. Photons are counted in those that fit to one camera sample in
  /// every pixel.
  struct Pass {
    std::uint32_t index = 0;
    double photons = 1;
    double photons_before = 0;  ///< of all passes before it: the more, the smaller the radius
  };
  /// The photons of one pass, with its wavelengths, of which each leads as many: paths from the
  /// camera have to be led by all four alike, too. Must be active. The same bits for any number of
  /// threads.
  CausticPass trace(const Pass& pass, const Heroes& wavelengths, ThreadPool& pool,
                    Counters& counters) const;
  /// What the photons of a pass are beside one camera sample in every pixel.
  struct Share {
    double cost = 0;   ///< rays over those of the samples
    double error = 0;  ///< share of the variance of both
  };
  const Share& share() const { return share_; }

 private:
  /// An emission that left photons.
  struct Useful {
    std::uint32_t number = 0;
    PhotonEmitter::Origin origin;
  };
  struct Yield {
    Photons photons;
    std::vector<Useful> useful;  ///< by ascending number
    Counters counters;
  };
  Yield emit(std::uint32_t pass, std::uint32_t count, const Heroes& wavelengths,
             ThreadPool& pool) const;
  State prepare(ThreadPool& pool);
  bool measure_widths(ThreadPool& pool);
  bool learn(ThreadPool& pool);
  /// What a small picture that gathers the photons of `count` emissions says of them. Variances are
  /// relative, of one sample of a pixel, the worst pixels left out; costs are rays.
  struct Judgement {
    std::vector<PhotonEmitter::Lesson> lessons;
    double variance_of_paths = 0, cost_of_paths = 0;
    /// With one emission a pixel, at the radius of the first pass; cost of one emission.
    double variance_of_photons = 0, cost_of_photons = 0;
    double left = 0;  ///< photons on surfaces, of one emission
  };
  Judgement judge(Yield yield, std::uint32_t count, ThreadPool& pool) const;
  void choose_number(const Judgement& judgement);
  struct SmallPicture;
  SmallPicture render_small(const CausticPass& pass, ThreadPool& pool) const;
  CausticPass pass_of(Yield yield, std::uint32_t count, double radius_per_width) const;

  const scene::Scene& scene_;
  Settings settings_;
  PhotonEmitter emitter_;
  PhotonTracer tracer_;
  State state_ = State::not_wanted;
  PhotonMap::Radii widths_;  ///< of the camera's cone where it meets what scatters widely
  double photons_per_pass_ = 0;
  double most_per_pass_ = 0;  ///< of any
  Share share_;
};

/// Radius of a gather after `passes` full passes, over that in the first: squares shrink by
/// (k + 2/3) / (k + 1) from the k-th pass to the next.
double radius_shrinkage(std::uint32_t passes);

}  // namespace lapidary::transport
