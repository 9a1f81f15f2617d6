#pragma once

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/log.h"
#include "base/parallel.h"
#include "geometry/compound_area.h"
#include "geometry/expression_part.h"
#include "scene/assemble.h"
#include "scene/prepare_light.h"

namespace lapidary::scene {

/// Makes lights of the surfaces of combinations: of each region one for every emissive material
/// that its leaves wear. Regions of one leaf are lights of other kinds.
class CombinationLights {
 public:
  struct Tools {
    SurfaceLights lights;
    ThreadPool& pool;
    WarningLog& warnings;
  };
  struct Found {
    geometry::SurfaceTag tag = 0;
    light::Light light;
  };

  /// `solids` and what `tools` refers to must outlive it and stay as they are.
  CombinationLights(const Solids& solids, const Tools& tools);

  /// `place` is that of the region's instance, 0 if it is none (geometry::Transition::place).
  ///
  /// Areas are known to 0.1 % (three standard errors) where light is stated as power, and else to
  /// 6 %, for choosing among lights. Warns of what is worn by nothing but what is cut away.
  /// Throws Error where what is worn has no bounds.
  std::vector<Found> of(const SolidRegion& region, std::uint32_t place);

 private:
  /// An expression to look into, prepared for that.
  struct Body;
  /// Leaves of a body that wear one thing: those that inherit, those of a tag of their own, or
  /// both.
  struct Wearers {
    bool inherit = false;
    geometry::SurfaceTag own = geometry::inherited_surface;
    auto operator<=>(const Wearers&) const = default;
  };
  struct Surface {
    /// Null when there is nothing of it.
    std::shared_ptr<const geometry::CompoundSurface> leaves;
    /// Of areas in the body's own coordinates, as far as they have been asked for.
    std::optional<geometry::AreaEstimate> rough, precise;
  };

  bool may_glow(const SolidRegion& region) const;
  std::shared_ptr<Body> body_of(const SolidRegion& region);
  std::vector<geometry::SurfaceTag> glowing_tags(const SolidRegion& region, const Body& body) const;
  std::optional<light::Light> light_of(const SolidRegion& region, std::uint32_t place, Body& body,
                                       geometry::SurfaceTag tag);
  Surface& surface_of(Body& body, const Wearers& wearers, const SolidRegion& region);
  geometry::AreaEstimate area_of(const Body& body, Surface& surface, const Transform& map,
                                 description::Quantity quantity);
  void warn_of(const geometry::AreaEstimate& area, description::Quantity quantity,
               const SolidRegion& region);
  const description::Emission* emission(geometry::SurfaceTag tag) const;

  const Solids& solids_;
  Tools tools_;
  std::vector<bool> glowing_objects_;  ///< that have a slot which glows
  std::map<std::uint32_t, std::shared_ptr<Body>> assemblies_;
};

}  // namespace lapidary::scene
