#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "math/transform.h"

namespace lapidary::scene {

/// `hash` with something more in it, for hash tables alone. The finaliser of splitmix64 (Steele,
/// Lea & Flood 2014) keeps what two neighbouring places differ in.
inline std::size_t mixed(std::size_t hash, std::uint64_t more) {
  std::uint64_t x = hash + 0x9E3779B97F4A7C15u + more;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return static_cast<std::size_t>(x ^ (x >> 31));
}

inline std::size_t mixed(std::size_t hash, Vec3d v) {
  for (std::size_t i = 0; i < 3; ++i) hash = mixed(hash, std::bit_cast<std::uint64_t>(v[i]));
  return hash;
}

inline std::size_t mixed(std::size_t hash, const Transform& map) {
  for (const Vec3d& row : map.linear().row) hash = mixed(hash, row);
  return mixed(hash, map.offset());
}

inline std::size_t mixed(std::size_t hash, const void* p) {
  return mixed(hash, std::uint64_t{reinterpret_cast<std::uintptr_t>(p)});
}

}  // namespace lapidary::scene
