#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "math/vec.h"

namespace lapidary::texture {

/// The cell of the lattice of whole numbers that a point is in, and where in it.
struct LatticePoint {
  std::array<std::uint32_t, 3> cell;  ///< modulo 2^32
  Vec3d within;                       ///< in [0, 1)
};

inline LatticePoint lattice_point(Vec3d p) {
  LatticePoint at;
  for (std::size_t i = 0; i < 3; ++i) {
    const double whole = std::floor(p[i]);
    const double rest = p[i] - whole;
    at.within[i] = rest < 1.0 ? rest : 0.0;  // just below a whole number may be rounded to it
    at.cell[i] = static_cast<std::uint32_t>(whole - 0x1p32 * std::floor(whole * 0x1p-32));
  }
  return at;
}

/// Bits of a cell that look independent of those of its neighbours and of other seeds.
inline std::uint32_t lattice_hash(std::uint32_t x, std::uint32_t y, std::uint32_t z,
                                  std::uint32_t seed) {
  std::uint32_t h = x * 0x9E3779B1u ^ (y * 0x85EBCA77u + 0x3C6EF372u) ^ (z * 0xC2B2AE3Du + seed);
  h = (h ^ (h >> 16)) * 0x7FEB352Du;
  h = (h ^ (h >> 15)) * 0x846CA68Bu;
  h += seed * 0x27D4EB2Fu;
  h = (h ^ (h >> 16)) * 0x7FEB352Du;
  return h ^ (h >> 15);
}

}  // namespace lapidary::texture
