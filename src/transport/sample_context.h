#pragma once

#include <cstdint>
#include <vector>

#include "camera/cone.h"
#include "math/vec.h"
#include "sampling/sobol.h"
#include "spectrum/wavelengths.h"
#include "transport/first_surface.h"

namespace lapidary::transport {

struct CausticPass;

/// What a photon gave to a path from the camera: the mean of its wavelengths [W/(m2 sr nm)].
struct GatheredPhoton {
  std::uint32_t number = 0;  ///< Photon::number
  float radiance = 0;
};

/// What all samples of one pixel in one pass share.
struct SampleContext {
  const Wavelengths& wavelengths;
  const PixelSampler& points;  ///< block 0 is the camera's, block 1 + n the n-th vertex's
  Counters& counters;
  camera::Cone cone;                                ///< of the camera's ray
  const CausticPass* caustics = nullptr;            ///< null: without photons
  std::vector<GatheredPhoton>* gathered = nullptr;  ///< where to note them; null: nowhere
};

/// Which of a vertex's eight dimensions decides what. Neighbours (0,1), (2,3) are stratified
/// together, so they go to the two-dimensional choices.
struct VertexPoints {
  explicit VertexPoints(const PixelSampler& points, int depth)
      : u(points.block(1 + static_cast<std::uint32_t>(depth))) {}

  Vec2d light_position() const { return {u[0], u[1]}; }
  Vec2d direction() const { return {u[2], u[3]}; }
  double light_choice() const { return u[4]; }
  double lobe_choice() const { return u[5]; }
  double roulette() const { return u[6]; }
  double presence() const { return u[7]; }

  Block8 u;
};

}  // namespace lapidary::transport
