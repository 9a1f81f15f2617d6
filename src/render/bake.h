#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "transport/illumination_maps.h"

namespace lapidary::render {

/// The illumination map of a surface as an image: irradiance [W/m2], linear Rec. 709, rows from
/// high v to low v. Texels within two of the surface repeat the nearest that has a value, so that
/// interpolation at its edge stays right; those farther off are black.
struct BakedImage {
  std::string name;     ///< of files, without extension; unique, letters, digits, _ and -
  std::string object;   ///< as the scene names it; may be empty
  std::string surface;  ///< what it is: "sphere", "cylinder", "rectangle", "mesh", ...
  std::uint32_t map_surface = 0;
  std::uint32_t chart = 0;  ///< of MappedSurface; of a mesh the image holds all
  transport::SurfaceSide side = transport::SurfaceSide::front;
  std::size_t photons = 0;
  image::Image image;
  /// Texture coordinates at the left and right edges, and at the lower and upper.
  Vec2d min, max;
  transport::TexelGrid ends;  ///< seams and poles
  /// Of a mesh: where its corners are in the image, from (0, 0) at the lower left to (1, 1): three
  /// for each triangle. Empty if the mesh's own coordinates say so.
  std::vector<std::array<Vec2d, 3>> atlas;
  std::string why_atlas;  ///< what is wrong with the mesh's own coordinates, if it has any
};

/// Every map as an image. Those of a mesh are in one for each side, its charts packed in rows with
/// at least two texels between them, unless it brought coordinates that can be used.
/// Failure: throws Error for more than 65536 images.
std::vector<BakedImage> bake(const scene::Scene& scene, const transport::IlluminationMaps& maps);

/// An OBJ file of a mesh in the world with the coordinates of its atlas.
std::string obj_with_atlas(const transport::MappedSurface& surface, const BakedImage& baked);

}  // namespace lapidary::render
