// Integration errors of the renderer's points against those of ideal ones: the same sequence under
// Owen's scrambling taken literally, with a fresh random bit at every node of every tree.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sampling/sobol.h"
#include "support/random.h"
#include "support/statistics.h"

namespace lapidary {
namespace {

using test::Random;
using Point = std::array<double, 8>;
using Points = std::vector<Point>;

constexpr int index_bits = 8;  // up to 256 samples

// GF(16) as polynomials in g over GF(4), by a table that is built from g's powers:
// g^2 = g + a, a = g^5 (bits 0, 1: 1, a; bits 2, 3: g, a g).
struct Field16 {
  std::array<int, 16> log{};
  std::array<int, 30> power{};

  Field16() {
    const auto times_g = [](int v) {
      // (l + h g) g = l g + h (g + a): the new h is l + h, the new l is h a.
      const int l = v & 3;
      const int h = v >> 2;
      constexpr std::array<int, 4> times_a{0, 2, 3, 1};
      return times_a[static_cast<std::size_t>(h)] | (l ^ h) << 2;
    };
    int v = 1;
    for (int n = 0; n < 30; ++n) {
      power[static_cast<std::size_t>(n)] = v;
      if (n < 15) log[static_cast<std::size_t>(v)] = n;
      v = times_g(v);
    }
  }
  int multiply(int x, int y) const {
    if (x == 0 || y == 0) return 0;
    return power[static_cast<std::size_t>(log[static_cast<std::size_t>(x)] +
                                          log[static_cast<std::size_t>(y)])];
  }
};

// Coefficients, lowest first, of a polynomial over GF(16).
using Polynomial = std::vector<int>;

// The digits of the fraction that Niederreiter's matrix for x - c gives an index: expand the
// polynomial of the index's digits about c, by repeated division by x - c (Horner).
std::vector<int> digits_about(const Field16& field, Polynomial p, int c) {
  std::vector<int> digits;
  while (!p.empty()) {
    for (std::size_t i = p.size() - 1; i-- > 0;) p[i] ^= field.multiply(c, p[i + 1]);
    digits.push_back(p.front());
    p.erase(p.begin());
  }
  return digits;
}

// Bits, lowest first, of `width`-bit digits and back.
Polynomial digits_of(unsigned bits, int width, int count) {
  Polynomial digits;
  for (int i = 0; i < count; ++i)
    digits.push_back(static_cast<int>(bits >> width * i) & ((1 << width) - 1));
  return digits;
}
unsigned bits_of(const std::vector<int>& digits, int width) {
  unsigned bits = 0;
  for (std::size_t i = 0; i < digits.size(); ++i)
    bits |= static_cast<unsigned>(digits[i]) << width * static_cast<int>(i);
  return bits;
}

// The first eight bits of the fraction of dimension d, first bit lowest.
unsigned unscrambled(const Field16& field, unsigned index, std::size_t d) {
  constexpr int b = 5;
  if (d >= 4) index = bits_of(digits_about(field, digits_of(index, 4, 2), b), 4);
  const int c = static_cast<int>(d % 4);
  const unsigned bits = bits_of(digits_about(field, digits_of(index, 2, 4), c), 2);
  return d % 2 == 1 ? bits ^ (bits >> 1 & 0x55U) : bits;
}

using Sequence = std::array<std::array<unsigned, 1U << index_bits>, 8>;

Sequence make_sequence() {
  const Field16 field;
  Sequence sequence;
  for (std::size_t d = 0; d < 8; ++d)
    for (unsigned i = 0; i < 1U << index_bits; ++i) sequence[d][i] = unscrambled(field, i, d);
  return sequence;
}

// Owen's scrambling: a random bit for each node of a binary tree.
class Tree {
 public:
  explicit Tree(Random& random) : flip_(1U << index_bits) {
    for (auto&& flip : flip_) flip = (random.bits() >> 40 & 1U) != 0;
  }
  // First bit lowest.
  unsigned scramble(unsigned value) const {
    unsigned result = 0;
    std::size_t node = 1;
    for (int i = 0; i < index_bits; ++i) {
      const unsigned bit = value >> i & 1U;
      result |= (bit ^ static_cast<unsigned>(flip_[node])) << i;
      node = 2 * node + bit;
    }
    return result;
  }

 private:
  std::vector<bool> flip_;
};

unsigned reversed(unsigned value) {
  unsigned result = 0;
  for (int i = 0; i < index_bits; ++i) result |= (value >> i & 1U) << (index_bits - 1 - i);
  return result;
}

// An unscrambled fraction has zeros after its first eight bits; their scrambling is a number of
// its own for each sample, since no two samples agree in the first eight.
Points ideal_points(unsigned count, Random& random) {
  static const Sequence sequence = make_sequence();
  const Tree order(random);
  Points points(count);
  for (std::size_t d = 0; d < 8; ++d) {
    const Tree tree(random);
    for (unsigned i = 0; i < count; ++i) {
      const unsigned index = reversed(order.scramble(reversed(i)));
      const unsigned bits = tree.scramble(sequence[d][index]);
      points[i][d] = std::ldexp(reversed(bits) + random.uniform(), -index_bits);
    }
  }
  return points;
}

Points renderer_points(unsigned count, Random& random) {
  const std::uint64_t seed = random.bits();
  const auto x = static_cast<std::uint32_t>(random.index(4096));
  Points points(count);
  for (unsigned i = 0; i < count; ++i) {
    const Block8 u = PixelSampler(seed, x, 11, i).block(3);
    for (std::size_t d = 0; d < 8; ++d) points[i][d] = u[d];
  }
  return points;
}

Points random_points(unsigned count, Random& random) {
  Points points(count);
  for (Point& point : points)
    for (double& u : point) u = random.uniform();
  return points;
}

enum class Shape { gaussian, ball };

struct Integrand {
  Shape shape;
  std::vector<std::size_t> dims;
  std::array<double, 3> at_most;  // error with 16, 64, 256 samples, in parts of the random one

  double operator()(const Point& p) const {
    double sum = 0.0;
    const double center = shape == Shape::gaussian ? 0.4 : 0.0;
    for (const std::size_t d : dims) sum += (p[d] - center) * (p[d] - center);
    if (shape == Shape::gaussian) return std::exp(-2.0 * sum);
    return sum < 0.32 * static_cast<double>(dims.size()) ? 1.0 : 0.0;
  }
};

// Standard deviation of the estimate. (That it is not biased, the uniformity of each sample says.)
template <typename Generator>
double error_of(const Integrand& f, const Generator& generate, unsigned count) {
  Random random(99);
  test::RunningMean estimates;
  for (int trial = 0; trial < 400; ++trial) {
    double sum = 0.0;
    for (const Point& p : generate(count, random)) sum += f(p);
    estimates.add(sum / count);
  }
  return std::sqrt(estimates.variance());
}

// Each error is known to 3.5 %, a ratio of two to 5 %. Both bounds are 4 standard errors away from
// what holds: 54 comparisons have a false-alarm rate of about 2e-3.
TEST(PixelSampler, IntegratesAsWellAsIdealScrambling) {
  const std::array<Integrand, 9> integrands{{
      {Shape::gaussian, {0, 1}, {0.16, 0.05, 0.014}},
      {Shape::gaussian, {6, 7}, {0.16, 0.05, 0.014}},
      {Shape::ball, {2, 3}, {0.5, 0.34, 0.25}},
      {Shape::gaussian, {1, 6}, {0.16, 0.05, 0.032}},
      {Shape::gaussian, {0, 1, 2, 3}, {0.22, 0.09, 0.027}},
      {Shape::ball, {4, 5, 6, 7}, {0.65, 0.55, 0.52}},
      {Shape::gaussian, {2, 3, 4, 5}, {0.22, 0.15, 0.05}},
      {Shape::gaussian, {0, 1, 2, 3, 4, 5, 6, 7}, {0.39, 0.31, 0.08}},
      {Shape::ball, {0, 1, 2, 3, 4, 5, 6, 7}, {0.7, 0.7, 0.67}},
  }};
  for (const Integrand& f : integrands)
    for (std::size_t n = 0; n < 3; ++n) {
      const unsigned count = 16U << 2 * n;
      const double ours = error_of(f, renderer_points, count);
      const double ideal = error_of(f, ideal_points, count);
      const double random = error_of(f, random_points, count);
      const std::string what = std::to_string(f.dims.size()) + "-D from dimension " +
                               std::to_string(f.dims.front()) + ", " + std::to_string(count) +
                               " samples: " + std::to_string(ours / random) + " of random, " +
                               std::to_string(ours / ideal) + " of ideal";
      EXPECT_LT(ours, 1.25 * ideal) << what;
      EXPECT_LT(ours, f.at_most[n] * random) << what;
    }
}

}  // namespace
}  // namespace lapidary
