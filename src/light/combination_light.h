#pragma once

#include <memory>
#include <optional>

#include "geometry/compound_surface.h"
#include "geometry/moving_transform.h"
#include "light/area_sample.h"
#include "light/influence.h"

namespace lapidary::light {

/// The part of a combination's surface that wears one emissive material, where the combination
/// stands. It shines out of the body: from a cut face out of the leaf that is left, into the one
/// that was taken away.
///
/// Points are drawn on the leaves that wear it, whether or not the boundary is there: a sample says
/// what it was drawn on (`LightSample::on_leaf`), and counts only if a ray finds just that. One
/// query so decides about shadows and about what is cut away, and of faces that coincide the
/// one leaf counts that the query reports. Light that leaves is drawn likewise
/// (`Departure::on_leaf`), from all of the leaves: the side that faces the direction counts as the
/// one that shines, which the query has to confirm.
class CombinationLight {
 public:
  struct Place {
    std::uint32_t number = 0;                    ///< geometry::Transition::place
    std::optional<geometry::OwnSpace> own = {};  ///< nothing for the world itself
    std::shared_ptr<const geometry::MovingTransform> motion = nullptr;  ///< null: at rest

    /// What `use` makes of its own coordinates, if it has any, at a time of the frame.
    template <typename Use>
    auto at(double time, Use&& use) const {
      if (!motion) return use(own);
      return use(std::optional(motion->space_at(time)));
    }
  };

  /// `surface` is in the coordinates of the compound; `area`, in the world, that of what is there
  /// of it: for `power` only.
  CombinationLight(std::shared_ptr<const geometry::CompoundSurface> surface, const Place& place,
                   double area, Spectrum radiance);

  std::optional<LightSample> sample_illumination(Vec3d p, const LightNumbers& numbers,
                                                 const Wavelengths& wavelengths) const;
  /// 0 where the light was met on what it does not draw from.
  double pdf_illumination(Vec3d p, Vec3d wi, const LightHit& hit) const;
  std::optional<Departure> sample_departure(Vec3d direction, const LightNumbers& numbers,
                                            const Wavelengths& wavelengths) const;
  double pdf_departure(Vec3d direction, const LightHit& hit) const;
  SampledSpectrum emitted(Vec3d wi, const LightHit& hit, const Wavelengths& wavelengths) const;
  double power(double scene_radius) const;
  Influence influence() const;

 private:
  /// A point drawn on a leaf, in the world.
  struct Drawn {
    SurfacePoint from;  ///< its normal out of the leaf
    geometry::LeafPatch on_leaf;
    float multiplicity = 1;  ///< geometry::LeafPoint::multiplicity

    /// Turns the normal to the side that `way` leads to.
    void turn_to(Vec3d way) {
      if (dot(from.normal, way) < 0.0) from.normal = -from.normal;
    }
  };
  /// `eye` in the world: geometry::LeafSurface::draw.
  std::optional<Drawn> draw(const LightNumbers& numbers, const std::optional<Vec3d>& eye) const;
  std::optional<Drawn> draw_in(const std::optional<geometry::OwnSpace>& own,
                               const LightNumbers& numbers, std::optional<Vec3d> eye) const;
  /// `density_in` the place as it is when the light is met.
  double density(const LightHit& hit) const;
  /// Per area, of the point that was met; 0 on what it does not draw from.
  double density_in(const std::optional<geometry::OwnSpace>& own, const LightHit& hit) const;

  std::shared_ptr<const geometry::CompoundSurface> surface_;
  Place place_;
  double area_ = 0;
  Spectrum radiance_;
};

}  // namespace lapidary::light
