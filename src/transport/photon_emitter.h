#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "light/departure.h"
#include "sampling/distribution.h"
#include "scene/scene.h"

namespace lapidary::transport {

/// Where photons are of use.
enum class Aim {
  casters,     ///< where they may be focused: what misses all targets is not traced
  everywhere,  ///< on every surface; those that may be focused are drawn more densely
  nowhere,     ///< as lights shine, which is not aimed at all
};

/// Sends photons from lights towards what may focus them, or everywhere.
///
/// Every photon belongs to one proposal: a light with a target, a ball around some casters, or with
/// none. From a light of finite extent the direction is uniform in the cone that holds all
/// directions from the light's ball to the target's, and the place is chosen among those that shine
/// along it, by projected area where the light can do so: all photons of a sphere then have the
/// same power. Of a ball, a rectangle or a disk, which may be larger than the target so that most
/// of these places would miss it, a place on the target's disc comes first, across the way from one
/// middle to the other, and light that arrives there. From infinite lights the direction is the
/// light's own choice, and the place uniform on the target's disc across it. The density of a
/// photon is that of all proposals of its light together; misses of all targets are known before
/// anything is traced, and count as emitted.
///
/// What photons of a first phase did teaches the emitter which proposals, and within them which
/// directions or places, are worth most; a share stays as it was. Source: after Grittmann et al.
/// 2018, "Efficient Caustic Rendering with Lightweight Photon Mapping", and, for the worth, Gruson
/// et al. 2016, "A Spatial Target Function for Metropolis Photon Tracing".
class PhotonEmitter {
 public:
  /// The scene must outlive the emitter.
  explicit PhotonEmitter(const scene::Scene& scene, Aim aim = Aim::casters);

  /// Whether there is a light that photons can leave and, if aimed at casters, one of these.
  bool is_useful() const { return chosen_.has_value(); }

  /// Everything that is lit as it should be; of radius 1 about the origin when nothing is bounded.
  /// That of all that is bounded, and where photons go everywhere and something is not, twice as
  /// large.
  const light::Ball& around() const { return around_; }

  /// What an emission is drawn with: uniform in [0, 1).
  struct Numbers {
    double proposal = 0;
    Vec2d direction;
    Vec2d place;
    double time = 0;  ///< of the frame
  };
  /// What a photon was drawn as: a point of the unit square of its proposal, which stands for its
  /// direction or, where that comes first, for its place at the target.
  struct Origin {
    std::uint32_t proposal = 0;
    Vec2d square;
  };
  /// What a photon of a first phase was worth: the sum, over all that look at the picture, of the
  /// square of what it gave to them over the error that they would not mind.
  struct Lesson {
    Origin origin;
    double worth = 0;
  };
  /// Learns from the photons of `emitted` that were worth anything. Of all densities, the one in
  /// proportion to the root of the mean square has the least variance. Before it is
  /// shared; a second time refines it.
  void learn(std::span<const Lesson> lessons, std::uint32_t emitted);

  /// Light that has left a light.
  struct Emission {
    Origin origin;
    std::uint32_t light = 0;
    geometry::Ray ray;      ///< from the point on the light, or from outside the scene
    SampledSpectrum power;  ///< [W/nm], of this photon if it were the only one
    double density = 0;     ///< per area across the ray and solid angle [1/(m2 sr)]; 0: no chance
    light::Extent extent = light::Extent::area;
    std::optional<geometry::LeafPatch> on_leaf;  ///< as LightSample::on_leaf
    bool from_surface = false;  ///< of a light that has one, which the ray is yet to leave
  };
  /// Nothing: a miss, or a sample of value zero.
  std::optional<Emission> sample(const Numbers& numbers, const Wavelengths& wavelengths) const;

  /// The density with which photons leave light `light` where it was met, against `wi` (unit,
  /// towards the light) by a ray from p; `hit` counts for finite ones. 0 for delta lights.
  double density(std::uint32_t light, Vec3d p, Vec3d wi, const light::LightHit& hit) const;

  /// A ball that casters lie in, with a box that they lie in, too.
  struct Target {
    Box3d box;
    light::Ball ball;
    double share = 0;  ///< of light that is focused
  };
  std::span<const Target> targets() const { return targets_; }

 private:
  static constexpr std::uint32_t no_target = ~0u;
  struct Cone {
    Vec3d axis{0, 0, 1};
    double one_minus_cos = 2;
  };
  /// A disk across the way from a light to a target.
  struct Disc {
    Vec3d axis;         ///< of that way; unit
    double radius = 0;  ///< all lines from the light's ball to the target's box cross it
  };
  struct Proposal {
    std::uint32_t light = 0;
    std::uint32_t target = no_target;
    Cone cone;                 ///< of finite lights
    std::optional<Disc> disc;  ///< where a place at the target comes first
    double probability = 0;
    std::optional<PiecewiseConstant2D> guide;  ///< over the square; uniform before it has learned

    /// The density on the square, of a point of it.
    double density(Vec2d square) const { return guide ? guide->pdf(square) : 1.0; }
  };

  void add_proposals(std::uint32_t light, std::vector<double>& weights);
  /// What the proposals of a light do together.
  std::span<const Proposal> proposals_of(std::uint32_t light) const;
  /// Of a ray that leaves a finite light at `hit`, where its place on the light is drawn with
  /// `pdf_on_light` along its direction.
  double density_of_rays(std::uint32_t light, Vec3d direction, const light::LightHit& hit,
                         double pdf_on_light) const;
  double density_through(const Proposal& proposal, Vec3d direction,
                         const light::LightHit& hit) const;
  double density_of_places(std::uint32_t light, Vec3d p, Vec3d direction) const;
  double density_of_cell(std::size_t proposal, std::size_t cell) const;
  void set_probabilities(std::span<const double> weights);
  std::optional<Emission> sample_finite(const Origin& origin, const Numbers& numbers, double part,
                                        const Wavelengths& wavelengths) const;
  std::optional<Emission> sample_through_disc(const Origin& origin, const Numbers& numbers,
                                              double part, const Wavelengths& wavelengths) const;
  std::optional<Emission> sample_infinite(const Origin& origin, const Numbers& numbers, double part,
                                          const Wavelengths& wavelengths) const;
  /// All of it but the ray and what the light's surface has to do with it.
  Emission emission_of(const Origin& origin, SampledSpectrum L, double density,
                       light::Extent extent) const;
  const light::Ball& ball_of(const Proposal& proposal) const {
    return proposal.target == no_target ? around_ : targets_[proposal.target].ball;
  }
  /// False only where there is nothing to be focused by, and that is what photons are for.
  bool may_meet(Vec3d origin, Vec3d direction) const;

  const scene::Scene& scene_;
  Aim aim_;
  light::Ball around_;
  std::vector<Target> targets_;
  bool all_bounded_ = true;           ///< no caster reaches beyond the targets
  std::vector<Proposal> proposals_;   ///< in the order of lights
  std::vector<std::uint32_t> first_;  ///< of each light's proposals, and the end
  std::optional<DiscreteDistribution> chosen_;
};

/// Casters gathered into at most `most` targets. What is unbounded is cut to `scene_box`.
std::vector<PhotonEmitter::Target> gather_targets(std::span<const scene::Caster> casters,
                                                  const Box3d& scene_box, std::size_t most);

}  // namespace lapidary::transport
