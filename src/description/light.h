#pragma once

#include <filesystem>
#include <variant>

#include "description/emission.h"
#include "math/vec.h"
#include "schema/call_site.h"

namespace lapidary::description {

// Lights with a surface (sphere_light, rectangle_light, disk_light, mesh_light) are not here: each
// is an Object that wears an Emissive material, and so visible like any other.

/// Light from one place in all directions alike.
struct PointLight {
  Vec3d position;
  Emission emission{Quantity::power};  ///< power or intensity
};

/// Light from one place as a luminaire was measured to give it.
struct ProfileLight {
  std::filesystem::path file;  ///< by ANSI/IES LM-63
  Vec3d position;
  Vec3d axis{0, 0, -1};  ///< of the file's vertical angle 0; not zero
  Vec3d up{0, 1, 0};     ///< towards its horizontal angle 0; not along the axis
  /// The power of all of it, or the intensity where the file says one candela.
  Emission emission{Quantity::intensity};
};

/// Light from one place within a cone.
struct SpotLight {
  Vec3d from{0, 0, 1};
  Vec3d at;
  double angle = 60;  ///< degrees, the whole cone, in (0, 180]
  double penumbra =
      0.2;  ///< share of the cone's half angle over which light fades to its rim, 0..1
  Emission emission{Quantity::power};  ///< power (within the cone) or intensity (on the axis)
};

/// Light that comes from one direction everywhere, as from the sun.
struct DistantLight {
  Vec3d direction{0, 0, -1};  ///< the way the light travels, of any length but zero
  double angle = 0;           ///< degrees, diameter of the source in the sky, in [0, 180)
  Emission emission{Quantity::irradiance};
};

/// The same radiance from all around.
struct ConstantEnvironment {
  Spectrum radiance = Spectrum::illuminant({1, 1, 1});  ///< [W/(m2 sr nm)]
};

/// A picture of everything far away, equirectangular: its top is +z and its centre column looks
/// along +y, before it is turned.
struct ImageEnvironment {
  std::filesystem::path file;
  double scale = 1;   ///< multiplies the image's radiance
  double rotate = 0;  ///< degrees about z, counter-clockwise from above
};

/// The sky of a clear day with its sun.
struct Sky {
  enum class Sun { shines, left_out };
  Vec3d to_sun{0, 0, 1};   ///< of any length but zero; at most 10 degrees below the horizon
  double turbidity = 2.5;  ///< 1 to 10
  double ground_albedo = 0.2;
  Sun sun = Sun::shines;
  double scale = 1;  ///< multiplies all light
};

struct Light {
  std::variant<PointLight, ProfileLight, SpotLight, DistantLight, ConstantEnvironment,
               ImageEnvironment, Sky>
      model;
  schema::CallSite where;
};

}  // namespace lapidary::description
