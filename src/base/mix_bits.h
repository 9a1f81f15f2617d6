#pragma once

#include <cstdint>

namespace lapidary {

/// A permutation of 64-bit numbers in which every bit of the input moves about half the bits of the
/// result. Source: Steele, Lea & Flood 2014, "Fast Splittable Pseudorandom Number Generators", with
/// the constants of Stafford's "Mix13".
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9U;
  x = (x ^ x >> 27) * 0x94d049bb133111ebU;
  return x ^ x >> 31;
}

}  // namespace lapidary
