#pragma once

#include <cmath>
#include <cstddef>

#include <xmmintrin.h>

namespace lapidary {

/// Values at the four hero wavelengths of a path, in one SIMD register.
/// Source: Wilkie et al. 2014, "Hero Wavelength Spectral Sampling".
class SampledSpectrum {
 public:
  static constexpr std::size_t size = 4;
  using Vector = float __attribute__((vector_size(16)));

  SampledSpectrum() : v_{0, 0, 0, 0} {}
  explicit SampledSpectrum(float value) : v_{value, value, value, value} {}
  SampledSpectrum(float a, float b, float c, float d) : v_{a, b, c, d} {}
  explicit SampledSpectrum(Vector v) : v_(v) {}
  /// `value` at wavelength i, 0 at the others.
  static SampledSpectrum only(std::size_t i, float value) {
    SampledSpectrum alone;
    alone.set(i, value);
    return alone;
  }

  float operator[](std::size_t i) const { return v_[i]; }
  void set(std::size_t i, float value) { v_[i] = value; }
  Vector vector() const { return v_; }

  SampledSpectrum& operator+=(SampledSpectrum b) { return v_ += b.v_, *this; }
  SampledSpectrum& operator-=(SampledSpectrum b) { return v_ -= b.v_, *this; }
  SampledSpectrum& operator*=(SampledSpectrum b) { return v_ *= b.v_, *this; }
  SampledSpectrum& operator*=(float s) { return v_ *= s, *this; }
  SampledSpectrum& operator/=(SampledSpectrum b) { return v_ /= b.v_, *this; }
  SampledSpectrum& operator/=(float s) { return v_ /= s, *this; }

  friend SampledSpectrum operator-(SampledSpectrum a) { return SampledSpectrum(-a.v_); }
  friend SampledSpectrum operator+(SampledSpectrum a, SampledSpectrum b) { return a += b; }
  friend SampledSpectrum operator-(SampledSpectrum a, SampledSpectrum b) { return a -= b; }
  friend SampledSpectrum operator*(SampledSpectrum a, SampledSpectrum b) { return a *= b; }
  friend SampledSpectrum operator*(SampledSpectrum a, float s) { return a *= s; }
  friend SampledSpectrum operator*(float s, SampledSpectrum a) { return a *= s; }
  friend SampledSpectrum operator/(SampledSpectrum a, SampledSpectrum b) { return a /= b; }
  friend SampledSpectrum operator/(SampledSpectrum a, float s) { return a /= s; }

  float sum() const { return (v_[0] + v_[1]) + (v_[2] + v_[3]); }
  float average() const { return 0.25f * sum(); }
  float max() const {
    const float a = v_[0] > v_[1] ? v_[0] : v_[1], b = v_[2] > v_[3] ? v_[2] : v_[3];
    return a > b ? a : b;
  }
  float min() const {
    const float a = v_[0] < v_[1] ? v_[0] : v_[1], b = v_[2] < v_[3] ? v_[2] : v_[3];
    return a < b ? a : b;
  }
  bool is_zero() const { return _mm_movemask_ps(_mm_cmpneq_ps(v_, _mm_setzero_ps())) == 0; }
  /// No infinity and no NaN.
  bool is_finite() const { return _mm_movemask_ps(_mm_cmpneq_ps(v_ - v_, _mm_setzero_ps())) == 0; }

 private:
  Vector v_;
};

/// Of non-negative values.
inline SampledSpectrum sqrt(SampledSpectrum a) {
  return {std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
}
inline SampledSpectrum exp(SampledSpectrum a) {
  return {std::exp(a[0]), std::exp(a[1]), std::exp(a[2]), std::exp(a[3])};
}
inline SampledSpectrum min(SampledSpectrum a, SampledSpectrum b) {
  return SampledSpectrum(b.vector() < a.vector() ? b.vector() : a.vector());
}
inline SampledSpectrum max(SampledSpectrum a, SampledSpectrum b) {
  return SampledSpectrum(a.vector() < b.vector() ? b.vector() : a.vector());
}
/// a / b, and 0 where b is 0: for factors that were zero before the division.
inline SampledSpectrum safe_div(SampledSpectrum a, SampledSpectrum b) {
  const SampledSpectrum::Vector zero{0, 0, 0, 0};
  return SampledSpectrum(b.vector() == zero ? zero : a.vector() / b.vector());
}

}  // namespace lapidary
