#pragma once

#include <cstddef>
#include <cstdint>

namespace lapidary {

/// Eight numbers in (0, 1).
struct Block8 {
  alignas(32) double u[8];

  constexpr double operator[](std::size_t i) const { return u[i]; }
};

/// The random numbers of one sample of one pixel: a pure function of (seed, pixel, sample,
/// dimension), cheap to make and to copy.
///
/// Dimensions come in blocks of eight. Over the samples 0, 1, 2, ... of a pixel, in every block
/// - each pair (2j, 2j + 1) is a (0, 2)-sequence in base 2: any aligned run of 2^n samples has one
///   point in every rectangle of area 2^-n whose sides are powers of 1/2;
/// - each half (0 .. 3, 4 .. 7) is a (0, 4)-sequence in base 4: any aligned run of 4^n samples has
///   one point in every box of volume 4^-n whose sides are powers of 1/4;
/// - the whole is a (0, 8)-sequence in base 16, in the same sense.
/// So what belongs together should share a pair, then a half. The first pair is Sobol's; his
/// further dimensions form no such pairs under any direction numbers, so the others are
/// Niederreiter's over the fields of 4 and 16 elements, which contain that pair.
///
/// All is Owen-scrambled, with independent keys for all blocks, pixels and seeds, and blocks are
/// shuffled against each other: a single number is uniform and numbers of different blocks or
/// pixels are independent. Numbers are odd multiples of 2^-33: never 0, never 1.
/// Sources: Sobol' 1967, Niederreiter 1987 (sequences); Ahmed et al. 2024, "SZ Sequences" (that
/// sequences for 2, 4, 16 dimensions can nest); Owen 1995; Burley 2020, "Practical Hash-based Owen
/// Scrambling" (scrambling, shuffled blocks).
class PixelSampler {
 public:
  /// Any pixel, any sample.
  PixelSampler(std::uint64_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample);

  /// Dimensions 8k .. 8k + 7. k < 2^28.
  Block8 block(std::uint32_t k) const;

 private:
  std::uint64_t key_;              // of the pixel
  std::uint32_t reversed_sample_;  // lowest bit first
};

/// Number `dimension` of the numbers that all pixels of a pass share (wavelengths), in (0, 1): over
/// the passes 0, 1, 2, ... an Owen-scrambled van der Corput sequence, independent between
/// dimensions: any aligned run of 2^n passes has one number in each interval of length 2^-n.
double pass_sample(std::uint64_t seed, std::uint32_t pass, std::uint32_t dimension);

}  // namespace lapidary
