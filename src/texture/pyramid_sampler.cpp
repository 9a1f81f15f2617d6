#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <immintrin.h>

#include "texture/pyramid.h"

namespace lapidary::texture {
namespace {

using Vector = float __attribute__((vector_size(16)));

struct FetchByteRgb {
  static constexpr std::size_t size = 3;  ///< of a pixel, in bytes
  using Value = Vector;
  const std::uint8_t* codes;
  const float* values;
  Vector operator()(std::size_t i) const {
    std::uint32_t c;
    std::memcpy(&c, codes + 3 * i, sizeof c);
    return Vector{values[c & 255], values[c >> 8 & 255], values[c >> 16 & 255], 0};
  }
  const void* address(std::size_t i) const { return codes + 3 * i; }
};
struct FetchByte {
  static constexpr std::size_t size = 1;  ///< of a pixel, in bytes
  using Value = float;
  const std::uint8_t* codes;
  const float* values;
  float operator()(std::size_t i) const { return values[codes[i]]; }
  const void* address(std::size_t i) const { return codes + i; }
};
struct FetchHalfRgb {
  static constexpr std::size_t size = 6;  ///< of a pixel, in bytes
  using Value = Vector;
  const std::uint16_t* bits;
  Vector operator()(std::size_t i) const {
    return _mm_cvtph_ps(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(bits + 3 * i)));
  }
  const void* address(std::size_t i) const { return bits + 3 * i; }
};
struct FetchHalf {
  static constexpr std::size_t size = 2;  ///< of a pixel, in bytes
  using Value = float;
  const std::uint16_t* bits;
  float operator()(std::size_t i) const { return _cvtsh_ss(bits[i]); }
  const void* address(std::size_t i) const { return bits + i; }
};

Rgb to_rgb(Vector v) {
  return {v[0], v[1], v[2]};
}
Rgb to_rgb(float v) {
  return {v, v, v};
}
/// Numbers in [0, 1) that look like chance, of the last digits of a place.
class Digits {
 public:
  explicit Digits(Vec2d uv) {
    const auto x = std::bit_cast<std::uint64_t>(uv.x), y = std::bit_cast<std::uint64_t>(uv.y);
    bits_ = x * 0x9E3779B97F4A7C15u + y * 0xC2B2AE3D27D4EB4Fu;
    bits_ = (bits_ ^ (bits_ >> 32)) * 0xD6E8FEB86659FD93u;
    bits_ ^= bits_ >> 32;
  }
  /// One of four.
  double number(int i) const { return static_cast<double>(bits_ >> (16 * i) & 0xFFFF) * 0x1p-16; }

 private:
  std::uint64_t bits_;
};

/// Exact at powers of 2, and straight lines between them. Precondition: positive.
double rough_log2(double x) {
  constexpr std::uint64_t one = std::bit_cast<std::uint64_t>(1.0);
  return static_cast<double>(static_cast<std::int64_t>(std::bit_cast<std::uint64_t>(x) - one)) *
         0x1p-52;
}

/// `u` where the picture or its nearest edge is: in [-1, 2].
double folded(double u, Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat:
      return u - std::floor(u);
    case Wrap::mirror: {
      const double pair = u - 2.0 * std::floor(0.5 * u);
      return pair > 1.0 ? 2.0 - pair : pair;
    }
    case Wrap::clamp:
      return std::clamp(u, 0.0, 1.0);
    case Wrap::black:
      break;
  }
  return std::clamp(u, -1.0, 2.0);
}

}  // namespace

/// Looks into a pyramid whose values `Fetch` reads.
template <typename Fetch>
class PyramidSampler {
 public:
  using Value = typename Fetch::Value;

  PyramidSampler(const Pyramid& pyramid, Fetch fetch, Wrap wrap, Filter filter)
      : pyramid_(pyramid), fetch_(fetch), wrap_(wrap), filter_(filter) {}

  Value glance(const UvFootprint& footprint) const {
    const auto& levels = pyramid_.levels_;
    const double pixels =
        std::abs(footprint.dx.x * footprint.dy.y - footprint.dx.y * footprint.dy.x) *
        pyramid_.width() * pyramid_.height();
    // Twice as coarse, four times the area; rounded to the nearest.
    const int level = pixels > 1.0 ? static_cast<int>(0.5 * rough_log2(pixels) + 0.5) : 0;
    const auto last = static_cast<int>(levels.size()) - 1;
    if (wrap_ == Wrap::black && level > last) return look_from_afar(footprint.uv, level - last);
    const auto& nearest = levels[static_cast<std::size_t>(std::min(level, last))];
    return texel(nearest, near(nearest, footprint.uv, Digits(footprint.uv)));
  }

  Value draw(const UvFootprint& footprint) const {
    const Streak streak = streak_of(footprint, pyramid_.width(), pyramid_.height(), filter_);
    const Digits digits(footprint.uv);
    const Vec2d uv = footprint.uv + streak.way * (digits.number(0) - 0.5);
    const double level = std::floor(0.5 * rough_log2(streak.size_squared) + digits.number(1));
    const auto last = static_cast<double>(pyramid_.levels_.size() - 1);
    if (level == 0.0 || level > last) return look(uv, level);
    const Pyramid::Level& drawn = pyramid_.levels_[static_cast<std::size_t>(level)];
    const Pixel pixel = near(drawn, uv, digits);
    expect_more_near(place_of(drawn, pixel.x, pixel.y));
    return texel(drawn, pixel);
  }

  Value mean(const UvFootprint& footprint) const {
    const Probes probes = probes_of(footprint, pyramid_.width(), pyramid_.height(), filter_);
    if (probes.count == 1) return look(footprint.uv, probes.level);
    Value sum{};
    const double before = 0.5 * (probes.count - 1);
    for (int i = 0; i < probes.count; ++i) {
      sum += look(footprint.uv + probes.step * (i - before), probes.level);
    }
    return sum * (1.0f / static_cast<float>(probes.count));
  }

 private:
  using Pixel = Vec2<int>;

  Value look(Vec2d uv, double level) const {
    const auto& levels = pyramid_.levels_;
    const double last = static_cast<double>(levels.size() - 1);
    if (wrap_ == Wrap::black && level > last) return look_from_afar(uv, level - last);
    const double u = folded(uv.x, wrap_), v = folded(uv.y, wrap_);
    if (!(level < last)) return at(levels.back(), u, v);
    const double whole = std::floor(level);
    const auto part = static_cast<float>(level - whole);
    const auto finer = static_cast<std::size_t>(whole);
    const Value a = at(levels[finer], u, v);
    if (part == 0.0f) return a;
    return a * (1.0f - part) + at(levels[finer + 1], u, v) * part;
  }

  /// At pixels that hold more and more of the nothing around the picture.
  Value look_from_afar(Vec2d uv, double levels_beyond) const {
    const double shrink = std::exp2(-levels_beyond);
    const double u = 0.5 + (uv.x - 0.5) * shrink, v = 0.5 + (uv.y - 0.5) * shrink;
    return at(pyramid_.levels_.back(), folded(u, wrap_), folded(v, wrap_)) *
           static_cast<float>(shrink * shrink);
  }

  Value at(const Pyramid::Level& level, double u, double v) const {
    if (filter_ == Filter::nearest) {
      return texel(level, static_cast<int>(std::floor(u * level.width)),
                   level.height - 1 - static_cast<int>(std::floor(v * level.height)));
    }
    const double x = u * level.width - 0.5, y = (1.0 - v) * level.height - 0.5;
    const double left = std::floor(x), above = std::floor(y);
    const auto tx = static_cast<float>(x - left), ty = static_cast<float>(y - above);
    const int i = static_cast<int>(left), j = static_cast<int>(above);
    const auto between = [&](Value a, Value b, Value c, Value d) {
      return (a + (b - a) * tx) * (1.0f - ty) + (c + (d - c) * tx) * ty;
    };
    if (i >= 0 && j >= 0 && i + 1 < level.width && j + 1 < level.height) {
      const std::size_t x0 = level.column(i), x1 = level.column(i + 1);
      const std::size_t y0 = level.row(j), y1 = level.row(j + 1);
      return between(fetch_(x0 + y0), fetch_(x1 + y0), fetch_(x0 + y1), fetch_(x1 + y1));
    }
    return between(texel(level, i, j), texel(level, i + 1, j), texel(level, i, j + 1),
                   texel(level, i + 1, j + 1));
  }

  /// One of the pixels that `at` is made of, each as often as it has weight there.
  Pixel near(const Pyramid::Level& level, Vec2d uv, const Digits& digits) const {
    const bool smooth = filter_ == Filter::smooth;
    const double dx = smooth ? digits.number(2) - 0.5 : 0.0;
    const double dy = smooth ? digits.number(3) - 0.5 : 0.0;
    const double x = folded(uv.x, wrap_) * level.width + dx;
    const double y = folded(uv.y, wrap_) * level.height + dy;
    return {static_cast<int>(std::floor(x)), level.height - 1 - static_cast<int>(std::floor(y))};
  }

  Value texel(const Pyramid::Level& level, Pixel pixel) const {
    return texel(level, pixel.x, pixel.y);
  }
  /// Precondition: at most one picture away.
  Value texel(const Pyramid::Level& level, int x, int y) const {
    if (wrap_ == Wrap::black && (x < 0 || y < 0 || x >= level.width || y >= level.height)) {
      return Value{};
    }
    return fetch_(place_of(level, x, y));
  }

  /// Has the square of a pixel come near: other samples of what is drawn for, and those beside it,
  /// draw there, too, and waiting for memory was most of what a draw took.
  void expect_more_near(std::size_t place) const {
    constexpr std::size_t area = Pyramid::Level::area;
    const auto* square = static_cast<const char*>(fetch_.address(place / area * area));
    for (std::size_t i = 0; i < area * Fetch::size; i += Texels::line) {
      __builtin_prefetch(square + i);
    }
  }

  std::size_t place_of(const Pyramid::Level& level, int x, int y) const {
    return level.column(inside(x, level.width)) + level.row(inside(y, level.height));
  }

  int inside(int i, int size) const {
    if (wrap_ != Wrap::repeat) return std::clamp(i, 0, size - 1);
    return i < 0 ? i + size : i >= size ? i - size : i;
  }

  const Pyramid& pyramid_;
  Fetch fetch_;
  Wrap wrap_;
  Filter filter_;
};

namespace {

/// `use(sampler)` with the one for the values that `texels` holds.
template <typename Use>
auto with_sampler(const Pyramid& pyramid, const Texels& texels, Wrap wrap, Filter filter, Use use) {
  const auto sampler = [&](auto fetch) {
    return use(PyramidSampler<decltype(fetch)>(pyramid, fetch, wrap, filter));
  };
  const bool colored = pyramid.channels() == 3;
  if (const auto* bytes = std::get_if<Texels::Bytes>(&texels.store())) {
    const auto* codes = bytes->codes.data();
    const float* values = bytes->scale->values();
    return colored ? sampler(FetchByteRgb{codes, values}) : sampler(FetchByte{codes, values});
  }
  const auto* bits = std::get<Texels::Halves>(texels.store()).bits.data();
  return colored ? sampler(FetchHalfRgb{bits}) : sampler(FetchHalf{bits});
}

}  // namespace

Rgb Pyramid::mean(const UvFootprint& footprint, Wrap wrap, Filter filter) const {
  return with_sampler(*this, texels_, wrap, filter,
                      [&](const auto& sampler) { return to_rgb(sampler.mean(footprint)); });
}

Rgb Pyramid::draw(const UvFootprint& footprint, Wrap wrap, Filter filter) const {
  return with_sampler(*this, texels_, wrap, filter,
                      [&](const auto& sampler) { return to_rgb(sampler.draw(footprint)); });
}

Rgb Pyramid::glance(const UvFootprint& footprint, Wrap wrap, Filter filter) const {
  return with_sampler(*this, texels_, wrap, filter,
                      [&](const auto& sampler) { return to_rgb(sampler.glance(footprint)); });
}

}  // namespace lapidary::texture
