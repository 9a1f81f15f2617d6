#include "texture/texels.h"

#include <algorithm>
#include <cmath>

#include <immintrin.h>

#include "spectrum/color.h"

namespace lapidary::texture {
namespace {

constexpr float largest_half = 65504.0f;

constexpr std::size_t padding = 3;

bool all_on(const ByteScale& scale, std::span<const float> values) {
  return std::all_of(values.begin(), values.end(),
                     [&](float v) { return scale.value(scale.nearest(v)) == v; });
}

std::uint16_t half_bits(float value) {
  const float held = std::clamp(value, -largest_half, largest_half);
  return static_cast<std::uint16_t>(_cvtss_sh(held, _MM_FROUND_TO_NEAREST_INT));
}

}  // namespace

ByteScale::ByteScale(float (*decode)(float)) {
  for (int code = 0; code < 256; ++code) {
    values_[static_cast<std::size_t>(code)] = decode(static_cast<float>(code) / 255.0f);
    limits_[static_cast<std::size_t>(code)] = decode((static_cast<float>(code) + 0.5f) / 255.0f);
  }
  limits_[255] = INFINITY;
  std::uint8_t code = 0;
  for (int bucket = 0; bucket <= buckets; ++bucket) {
    while (limits_[code] < static_cast<float>(bucket) / buckets) ++code;
    first_[static_cast<std::size_t>(bucket)] = code;
  }
}

const ByteScale& ByteScale::srgb() {
  static const ByteScale scale([](float signal) { return srgb_decode(signal); });
  return scale;
}

const ByteScale& ByteScale::linear() {
  static const ByteScale scale([](float signal) { return signal; });
  return scale;
}

std::uint8_t ByteScale::nearest(float value) const {
  const float inside = std::clamp(value, 0.0f, 1.0f);
  std::uint8_t code = first_[static_cast<std::size_t>(inside * buckets)];
  while (limits_[code] < inside) ++code;
  return code;
}

Texels::Texels(std::span<const float> like, std::size_t count) {
  for (const ByteScale* scale : {&ByteScale::srgb(), &ByteScale::linear()}) {
    if (!all_on(*scale, like)) continue;
    store_ = Bytes{decltype(Bytes::codes)(count + padding), scale};
    return;
  }
  store_ = Halves{decltype(Halves::bits)(count + padding)};
}

void Texels::append(std::span<const float> values) {
  if (auto* bytes = std::get_if<Bytes>(&store_)) {
    for (const float v : values) bytes->codes[used_++] = bytes->scale->nearest(v);
  } else {
    for (const float v : values) std::get<Halves>(store_).bits[used_++] = half_bits(v);
  }
}

std::size_t Texels::bytes() const {
  const auto* bytes = std::get_if<Bytes>(&store_);
  return bytes ? bytes->codes.size() : 2 * std::get<Halves>(store_).bits.size();
}

}  // namespace lapidary::texture
