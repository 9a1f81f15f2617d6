#pragma once

#include <optional>
#include <variant>

#include "light/combination_light.h"
#include "light/departure.h"
#include "light/disk_light.h"
#include "light/distant_light.h"
#include "light/environment.h"
#include "light/illumination.h"
#include "light/influence.h"
#include "light/mesh_light.h"
#include "light/point_light.h"
#include "light/profile_light.h"
#include "light/rectangle_light.h"
#include "light/solid_light.h"
#include "light/sphere_light.h"
#include "spectrum/wavelengths.h"

/// Emitters, in world space. Radiance is in W/(m2 sr nm), power in W, lengths in scene units.
/// Solids shine outward, sheets and triangles to their front.
namespace lapidary::light {

using Light = std::variant<SphereLight, RectangleLight, DiskLight, MeshLight, SolidLight,
                           CombinationLight, PointLight, SpotLight, ProfileLight, DistantLight,
                           ConstantEnvironment, ImageEnvironment>;

/// A direction from `p` towards the light with the light that comes from there, drawn with density
/// `pdf_illumination`. Nothing when the light cannot reach `p` or the drawn point turns its back to
/// it: a sample of value zero. What the sample says about when it counts is the caller's to check.
/// Directions below the horizon of `p` are the caller's to drop.
std::optional<LightSample> sample_illumination(const Light& light, Vec3d p,
                                               const LightNumbers& numbers,
                                               const Wavelengths& wavelengths);

/// Density per solid angle [1/sr] with which `sample_illumination` draws, from `p`, the direction
/// `wi` (unit length), along which a ray met the light at `hit`, or left the scene if the light is
/// infinite. 0 for delta lights.
double pdf_illumination(const Light& light, Vec3d p, Vec3d wi, const LightHit& hit);

/// Light that leaves along `direction` (unit length, away from the light) from a point that is
/// drawn with density `pdf_departure`. Nothing when the drawn point turns away from it, or a
/// point-like light does not shine there: a sample of value zero. Nothing from infinite lights,
/// which know no point. What the sample says about when it counts is the caller's to check.
std::optional<Departure> sample_departure(const Light& light, Vec3d direction,
                                          const LightNumbers& numbers,
                                          const Wavelengths& wavelengths);

/// Density, per area projected along `direction` [1/m2], with which `sample_departure` draws, for
/// that direction, the point of `hit`. 0 for point-like and infinite lights, and for points that
/// turn away.
double pdf_departure(const Light& light, Vec3d direction, const LightHit& hit);

/// Radiance that a ray along `wi` (unit length, towards the light) meets at `hit`, or on leaving
/// the scene. 0 from behind, and for delta lights.
SampledSpectrum emitted(const Light& light, Vec3d wi, const LightHit& hit,
                        const Wavelengths& wavelengths);

/// Radiant power over 360-830 nm [W] that the light sends out, or, if it is infinite, into a sphere
/// of `scene_radius` around the scene. For choosing lights; a picture's is that of its pixels
/// without interpolation.
double power(const Light& light, double scene_radius);

/// How much the light could matter at a point, for choosing among a few.
Influence influence(const Light& light);

/// A ball that holds all that shines, within rounding and at all times of the frame. Nothing for
/// infinite lights and those without a surface.
std::optional<Ball> bounding_ball(const Light& light);

/// Never met by chance, only by `sample_illumination`.
bool is_delta(const Light& light);

/// Shines from beyond the scene: rays that leave it meet this light.
bool is_infinite(const Light& light);

}  // namespace lapidary::light
