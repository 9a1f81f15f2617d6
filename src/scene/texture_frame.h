#pragma once

#include <cstdint>

#include "math/transform.h"

namespace lapidary::scene {

/// The coordinates that textures are in: those of the object that was given the material.
struct TextureFrame {
  /// What it stands in: the world or, for parts of a combination that stands in several places, the
  /// combination's own coordinates.
  enum class Base : std::uint8_t { world, place };

  Transform wearer_from_base;
  Base base = Base::world;

  bool operator==(const TextureFrame&) const = default;
};

}  // namespace lapidary::scene
