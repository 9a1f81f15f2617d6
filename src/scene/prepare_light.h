#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/input_files.h"
#include "description/light.h"
#include "description/material.h"
#include "geometry/placed_solid.h"
#include "geometry/sheet.h"
#include "geometry/triangle_scene.h"
#include "light/light.h"

namespace lapidary::scene {

/// What preparing a light needs beside its description.
struct LightPreparation {
  double metres = 1;            ///< the length of a scene unit
  InputFiles* files = nullptr;  ///< notes what is read; may be null
};

/// What a light of the scene's `lights` list is made of: a sky of two, all others of one. Reads
/// files; throws Error for those that cannot be used.
std::vector<light::Light> prepare_lights(const description::Light& light,
                                         const LightPreparation& preparation);

/// Makes the lights that surfaces are which wear an emissive material.
class SurfaceLights {
 public:
  /// `metres` is the length of a scene unit.
  explicit SurfaceLights(double metres) : metres_(metres) {}

  /// Throws Error at `where` for solids that have no finite surface.
  light::Light solid(const geometry::PlacedSolid& solid, const description::Emission& emission,
                     const schema::CallSite& where) const;
  /// `area` is that of what is there of the surface, in the world; 0 makes it dark where light is
  /// stated as power.
  light::Light combination(std::shared_ptr<const geometry::CompoundSurface> surface,
                           const light::CombinationLight::Place& place, double area,
                           const description::Emission& emission) const;
  light::Light sheet(const geometry::Sheet& sheet, const description::Emission& emission) const;
  /// The triangles of `placement` that `chosen` lists.
  light::Light mesh(const geometry::MeshPlacement& placement, std::span<const std::uint32_t> chosen,
                    const description::Emission& emission) const;

 private:
  /// Of a surface of `area` square scene units.
  Spectrum radiance(const description::Emission& emission, double area) const;

  double metres_;
};

}  // namespace lapidary::scene
