#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "math/vec.h"
#include "spectrum/sampled_spectrum.h"

namespace lapidary::transport {

/// What light has met before it fell where a photon is.
enum class Course : std::uint8_t {
  focused,   ///< only what scatters narrowly: it may be sharp as an edge
  diffused,  ///< something that scatters widely, too: it is about the same all around
};

/// A length in 16 bits, at most 1 % too large.
class CoarseLength {
 public:
  CoarseLength() = default;
  /// `length` >= 0; it may be infinite.
  explicit CoarseLength(float length)
      : bits_(static_cast<std::uint16_t>((std::bit_cast<std::uint32_t>(length) + 0xffffu) >> 16)) {}
  float value() const { return std::bit_cast<float>(std::uint32_t{bits_} << 16); }

 private:
  std::uint16_t bits_ = 0;
};

/// Light that a caustic's path brought to a surface that scatters widely.
struct Photon {
  /// [W/nm] of one of the photons of a pass, before that is divided by them; if all wavelengths had
  /// gone the hero's way.
  SampledSpectrum power;
  Vec3f position;  ///< from the origin of its map
  Vec3f wi;        ///< unit, back where it came from
  Vec3f normal;    ///< unit, geometric, on the side of `wi`
  /// Of a photon that has met nothing but focusing surfaces: how densely photons like it leave
  /// their light [1/(m2 sr)], for weighing against chance hits. 0 after wide scattering: chance
  /// hits do not count there.
  float density = 0;
  std::uint32_t number = 0;  ///< of the emission it comes from, in its pass
  std::uint16_t depth = 0;   ///< scattering events between the light and here
  CoarseLength dispersion;   ///< how far from here, about, other wavelengths fell; scene units

  /// Which wavelength led it, where a pass's lead in turns.
  std::size_t hero() const { return number % SampledSpectrum::size; }
};

static_assert(sizeof(Photon) == 64);

/// Photons by their course.
struct Photons {
  std::vector<Photon> focused, diffused;

  std::size_t size() const { return focused.size() + diffused.size(); }
};

/// Glass that disperses sends every wavelength its own way, and a photon goes the hero's. What it
/// brings to who looks at a disk of some radius about it: where others fell much nearer than that
/// to it, all wavelengths; where they fell far off, the hero's alone, four times, as photons that
/// others lead bring theirs; a mixture between, so that no edge shows. What this adds to the blur
/// of the disk vanishes faster than that.
inline SampledSpectrum light_within(double radius, const SampledSpectrum& power, float dispersion,
                                    std::size_t hero) {
  if (dispersion == 0.0f) return power;
  // Colours may not shift by more than a small part of what is blurred anyway.
  constexpr float largest = 0.5f;
  const float shift = dispersion / (largest * static_cast<float>(radius));
  const float together = std::max(0.0f, 1.0f - shift * shift);
  const SampledSpectrum alone = SampledSpectrum::only(hero, 4.0f * (1.0f - together) * power[hero]);
  return together * power + alone;
}

}  // namespace lapidary::transport
