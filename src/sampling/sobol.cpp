#include "sampling/sobol.h"

#include <array>

#include <immintrin.h>

#include "base/mix_bits.h"

// How a block is made:
//
//   sample number -> shuffled by the block's key -> fractions of eight dimensions by their
//   generator matrices -> each scrambled by its dimension's key -> doubles
//
// Shuffling and scrambling are nested uniform permutations: every bit is flipped or not by a hash
// of the bits before it. The arithmetic that does this works from the lowest bit up, so samples and
// fractions are kept with their first bit (the highest) lowest, and matrices have row 0, which
// makes the first bit of the fraction, in bit 0.
namespace lapidary {
namespace {

// Eight lanes of AVX2, one for each dimension of a block.
using Lanes = std::uint32_t __attribute__((vector_size(32)));

// The dimension in each lane. Widening to doubles takes lanes 0, 1, 4, 5 and lanes 2, 3, 6, 7.
constexpr std::array<std::uint32_t, 8> dimension_of_lane{0, 1, 4, 5, 2, 3, 6, 7};

// ---- Generator matrices --------------------------------------------------------------------

// Bit i of element j is row i, column j. Column j belongs to bit 2^j of the sample number.
using Matrix = std::array<std::uint32_t, 32>;

constexpr std::uint32_t operator*(const Matrix& m, std::uint32_t v) {
  std::uint32_t sum = 0;
  for (std::size_t j = 0; j < 32; ++j)
    if (v >> j & 1U) sum ^= m[j];
  return sum;
}

constexpr Matrix operator*(const Matrix& a, const Matrix& b) {
  Matrix product{};
  for (std::size_t j = 0; j < 32; ++j) product[j] = a * b[j];
  return product;
}

// The field of 4 elements: bit 0 counts 1, bit 1 counts a, and a^2 = a + 1.
constexpr std::uint32_t multiply4(std::uint32_t x, std::uint32_t y) {
  const std::uint32_t x_times_a = (x >> 1) | ((x ^ x << 1) & 2U);
  return (y & 1U ? x : 0U) ^ (y & 2U ? x_times_a : 0U);
}

// The field of 16 elements, l + h g with l, h of the field of 4, and g^2 = g + a.
constexpr std::uint32_t multiply(std::uint32_t x, std::uint32_t y) {
  const std::uint32_t hh = multiply4(x >> 2, y >> 2);
  const std::uint32_t low = multiply4(x & 3U, y & 3U) ^ multiply4(hh, 2U);
  const std::uint32_t high = multiply4(x & 3U, y >> 2) ^ multiply4(x >> 2, y & 3U) ^ hh;
  return low | high << 2;
}

// Niederreiter's matrix for the polynomial x - c over the field of 2^digit_bits elements (one of
// the two above): digit (i, j) is binomial(j, i) c^(j - i). P(c) P(d) = P(c + d).
constexpr Matrix pascal(std::uint32_t digit_bits, std::uint32_t c) {
  const std::uint32_t digits = 32 / digit_bits;
  std::array<std::uint32_t, 16> power{1};
  for (std::size_t n = 1; n < digits; ++n) power[n] = multiply(power[n - 1], c);
  Matrix m{};
  for (std::uint32_t j = 0; j < 32; ++j)
    for (std::uint32_t i = 0; i <= j / digit_bits; ++i) {
      const std::uint32_t column = j / digit_bits;
      const bool odd = (i & column) == i;  // the binomial, by Lucas's theorem
      if (odd) m[j] |= multiply(power[column - i], 1U << j % digit_bits) << digit_bits * i;
    }
  return m;
}

// Adds the second bit of each base-4 digit to the first.
constexpr Matrix fold() {
  Matrix m{};
  for (std::uint32_t j = 0; j < 32; ++j) m[j] = j % 2 == 0 ? 1U << j : 3U << (j - 1);
  return m;
}

// The eight dimensions. P over the field of 4, Q over that of 16, T = fold():
//
//   P(0), T P(1), P(a), T P(a + 1), and the same four times Q(b)
//
// - P(0) = 1 and T P(1), Pascal's triangle modulo 2, are Sobol's first pair: a (0, 2)-sequence.
//   P(a), T P(a + 1) is that pair times P(a), because P adds. P(a) and Q(b) only reorder the
//   sample numbers within every aligned run of 2^n, so all four pairs are (0, 2)-sequences.
// - The first four are Niederreiter's (0, 4)-sequence in base 4, with the values of the digits
//   renamed by T; Q(b) keeps that too.
// - By Lucas's theorem P(c) is Q(c^2) up to a map of each base-16 digit, so the eight are Q of
//   eight different numbers, c^2 and c^2 + b, in which b is outside the field of 4: eight of the
//   sixteen dimensions of Niederreiter's (0, 16)-sequence in base 16.
// All twelve choices of b integrate better than two shuffled sets of four; 1 + g did best on the
// whole over smooth and discontinuous functions of 2 to 8 dimensions at 16, 64 and 256 samples.
constexpr std::array<Matrix, 8> make_dimensions() {
  constexpr std::uint32_t a = 2;
  constexpr std::uint32_t b = 5;
  const Matrix t = fold();
  const Matrix q = pascal(4, b);
  std::array<Matrix, 8> m{pascal(2, 0), t * pascal(2, 1), pascal(2, a), t * pascal(2, a + 1)};
  for (std::size_t d = 0; d < 4; ++d) m[d + 4] = m[d] * q;
  return m;
}

// Products of the matrices with every value of each nibble of a sample number, first bit lowest:
// 4 KiB, an eighth of the nearest cache.
struct Products {
  alignas(64) std::array<std::array<std::array<std::uint32_t, 8>, 16>, 8> of_nibble{};
};

constexpr Products make_products() {
  const std::array<Matrix, 8> dimensions = make_dimensions();
  Products products;
  for (std::size_t nibble = 0; nibble < 8; ++nibble)
    for (std::size_t value = 0; value < 16; ++value)
      for (std::size_t lane = 0; lane < 8; ++lane)
        for (std::size_t bit = 0; bit < 4; ++bit)
          if (value >> bit & 1U)
            products.of_nibble[nibble][value][lane] ^=
                dimensions[dimension_of_lane[lane]][31 - (4 * nibble + bit)];
  return products;
}

constexpr Products products = make_products();

Lanes fractions(std::uint32_t sample) {
  const auto row = [sample](std::size_t nibble) {
    const std::size_t value = sample >> 4 * nibble & 15U;
    const void* lanes = products.of_nibble[nibble][value].data();
    return reinterpret_cast<Lanes>(_mm256_load_si256(static_cast<const __m256i*>(lanes)));
  };
  return ((row(0) ^ row(1)) ^ (row(2) ^ row(3))) ^ ((row(4) ^ row(5)) ^ (row(6) ^ row(7)));
}

// ---- Keys and permutations -----------------------------------------------------------------

// Independent keys of the eight dimensions of a block, from the block's key.
// Source of the multipliers and shifts: Wellons, "hash-prospector", the best found of this form.
Lanes dimension_keys(std::uint32_t block_key) {
  // Multiples of the golden ratio, 2^32 / 1.618: as far apart as eight numbers can be.
  constexpr Lanes offset = {0x00000000U, 0x9e3779b9U, 0x3c6ef372U, 0xdaa66d2bU,
                            0x78dde6e4U, 0x1715609dU, 0xb54cda56U, 0x5384540fU};
  Lanes x = offset + block_key;
  x = (x ^ x >> 16) * 0x21f0aaadU;
  x = (x ^ x >> 15) * 0xd35a2d97U;
  return x ^ x >> 15;
}

// A nested uniform permutation, first bit lowest: products and sums carry upwards only, so that no
// bit of the result depends on a bit above it. T is an integer or eight of them.
// Source: the form is Laine & Karras 2011, "Stratified Sampling for Stochastic Transparency"; this
// sequence and its constants are Vegdahl 2021, "Building a Better LK Hash".
template <typename T>
T permute(T x, T key) {
  x ^= x * 0x3d20adeaU;
  x += key;
  x *= key >> 16 | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

// ---- Bits to doubles -----------------------------------------------------------------------

std::uint32_t reverse_bits(std::uint32_t v) {
  v = (v >> 1 & 0x55555555U) | (v & 0x55555555U) << 1;
  v = (v >> 2 & 0x33333333U) | (v & 0x33333333U) << 2;
  v = (v >> 4 & 0x0f0f0f0fU) | (v & 0x0f0f0f0fU) << 4;
  return __builtin_bswap32(v);
}

// The middle of the cell of length 2^-32 that `fraction` names, first bit lowest.
double to_unit_interval(std::uint32_t fraction) {
  return (reverse_bits(fraction) + 0.5) * 0x1p-32;
}

// The same for eight. The bits of each fraction are reversed, nibbles by table and bytes in place,
// into the significand of a number in [16, 17), where they start on a byte.
Block8 to_unit_interval(Lanes fraction) {
  const __m256i reversed =
      _mm256_setr_epi8(0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15,  //
                       0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15);
  const __m256i first_two =
      _mm256_setr_epi8(-1, -1, 3, 2, 1, 0, -1, -1, -1, -1, 7, 6, 5, 4, -1, -1,  //
                       -1, -1, 3, 2, 1, 0, -1, -1, -1, -1, 7, 6, 5, 4, -1, -1);
  const __m256i last_two =
      _mm256_setr_epi8(-1, -1, 11, 10, 9, 8, -1, -1, -1, -1, 15, 14, 13, 12, -1, -1,  //
                       -1, -1, 11, 10, 9, 8, -1, -1, -1, -1, 15, 14, 13, 12, -1, -1);
  const __m256i sixteen_and_half_a_cell = _mm256_set1_epi64x(0x4030000000008000);

  const auto low = reinterpret_cast<__m256i>(fraction & 0x0f0f0f0fU);
  const auto high = reinterpret_cast<__m256i>(fraction >> 4 & 0x0f0f0f0fU);
  const __m256i bytes = _mm256_or_si256(_mm256_slli_epi32(_mm256_shuffle_epi8(reversed, low), 4),
                                        _mm256_shuffle_epi8(reversed, high));
  const auto widen = [&](__m256i lanes) {
    const __m256i bits =
        _mm256_or_si256(_mm256_shuffle_epi8(bytes, lanes), sixteen_and_half_a_cell);
    return _mm256_sub_pd(_mm256_castsi256_pd(bits), _mm256_set1_pd(16.0));
  };
  Block8 block;
  _mm256_store_pd(block.u, widen(first_two));
  _mm256_store_pd(block.u + 4, widen(last_two));
  return block;
}

}  // namespace

PixelSampler::PixelSampler(std::uint64_t seed, std::uint32_t x, std::uint32_t y,
                           std::uint32_t sample)
    : key_(mix_bits(mix_bits(seed) + (static_cast<std::uint64_t>(y) << 32 | x))),
      reversed_sample_(reverse_bits(sample)) {}

Block8 PixelSampler::block(std::uint32_t k) const {
  // Keys of one pixel are a Weyl sequence through a mixer, as those of a generator are.
  const std::uint64_t key = mix_bits(key_ + k * 0x9e3779b97f4a7c15U);
  const std::uint32_t shuffled = permute(reversed_sample_, static_cast<std::uint32_t>(key));
  const Lanes keys = dimension_keys(static_cast<std::uint32_t>(key >> 32));
  return to_unit_interval(permute(fractions(shuffled), keys));
}

double pass_sample(std::uint64_t seed, std::uint32_t pass, std::uint32_t dimension) {
  // Another constant than any pixel's, so that passes and pixels have nothing in common.
  const std::uint64_t key = mix_bits(mix_bits(~seed) ^ mix_bits(0x6a09e667f3bcc909U + dimension));
  const std::uint32_t shuffled = permute(reverse_bits(pass), static_cast<std::uint32_t>(key));
  // Van der Corput's fraction is the number itself with its bits reversed.
  return to_unit_interval(permute(reverse_bits(shuffled), static_cast<std::uint32_t>(key >> 32)));
}

}  // namespace lapidary
