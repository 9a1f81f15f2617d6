#pragma once

#include <string>
#include <utility>
#include <vector>

#include "light/light.h"

namespace lapidary::light::test {

using geometry::Box;
using geometry::Cylinder;
using geometry::Disk;
using geometry::PlacedSolid;
using geometry::Rectangle;
using geometry::TriangleMesh;

/// The same radiance at every wavelength: `lit` of a sample is a number.
inline Spectrum white(float radiance = 1.0f) {
  return Spectrum::constant(radiance);
}

inline const Wavelengths& wavelengths() {
  static const Wavelengths sampled = Wavelengths::sample(0.37);
  return sampled;
}

/// The flat square of two triangles over [-1, 1]^2 at z = 0, its front up, and a third one
/// that leans, with no smooth normals.
inline TriangleMesh roof() {
  TriangleMesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1.5f}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {2, 3, 4}};
  return mesh;
}

/// A picture with a bright spot, dark regions and a black row.
inline ImageEnvironment::Picture sky(std::size_t width = 16, std::size_t height = 8) {
  ImageEnvironment::Picture picture{width, std::vector<Rgb>(width * height), 0.6};
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    const auto v = static_cast<float>((i * 7) % 5);
    if (i / width != height / 2 && i / width != height / 2 + 1)
      picture.pixels[i] = {0.1f * v, 0.3f, 0.2f * v};
  }
  picture.pixels[2 * width + 3] = {30, 20, 10};
  return picture;
}

}  // namespace lapidary::light::test
