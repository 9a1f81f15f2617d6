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
/// one leaf counts that the query reports.
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
  SampledSpectrum emitted(Vec3d wi, const LightHit& hit, const Wavelengths& wavelengths) const;
  std::optional<Departure> sample_departure(Vec3d direction, const LightNumbers& numbers,
                                            const Wavelengths& wavelengths) const;
  double pdf_departure(Vec3d direction, const LightHit& hit) const;
  double power(double scene_radius) const;
  Influence influence() const;

 private:
  /// A point that shines towards an eye.
  struct Drawn {
    SurfacePoint from;
    float multiplicity = 1;
    geometry::LeafPatch on_leaf;
  };
  std::optional<Drawn> draw(const std::optional<geometry::OwnSpace>& own, Vec3d eye,
                            const LightNumbers& numbers) const;
  Box3d bounds() const;  ///< over the whole frame
  double density_at(const LightHit& hit) const;
  /// Per area, of the point that was met.
  double density_in(const std::optional<geometry::OwnSpace>& own, const LightHit& hit) const;

  std::shared_ptr<const geometry::CompoundSurface> surface_;
  Place place_;
  double area_ = 0;
  Ball ball_;
  Spectrum radiance_;
};

}  // namespace lapidary::light
