#pragma once

#include <cstddef>

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

  float operator[](std::size_t i) const { return v_[i]; }
  void set(std::size_t i, float value) { v_[i] = value; }
  Vector vector() const { return v_; }

  SampledSpectrum& operator+=(SampledSpectrum b) { return v_ += b.v_, *this; }
  SampledSpectrum& operator*=(SampledSpectrum b) { return v_ *= b.v_, *this; }
  SampledSpectrum& operator*=(float s) { return v_ *= s, *this; }

  friend SampledSpectrum operator+(SampledSpectrum a, SampledSpectrum b) { return a += b; }
  friend SampledSpectrum operator-(SampledSpectrum a, SampledSpectrum b) {
    return SampledSpectrum(a.v_ - b.v_);
  }
  friend SampledSpectrum operator*(SampledSpectrum a, SampledSpectrum b) { return a *= b; }
  friend SampledSpectrum operator*(SampledSpectrum a, float s) { return a *= s; }
  friend SampledSpectrum operator*(float s, SampledSpectrum a) { return a *= s; }
  friend SampledSpectrum operator/(SampledSpectrum a, SampledSpectrum b) {
    return SampledSpectrum(a.v_ / b.v_);
  }

  float sum() const { return (v_[0] + v_[1]) + (v_[2] + v_[3]); }
  float average() const { return 0.25f * sum(); }
  float max() const {
    const float a = v_[0] > v_[1] ? v_[0] : v_[1], b = v_[2] > v_[3] ? v_[2] : v_[3];
    return a > b ? a : b;
  }
  bool is_zero() const { return v_[0] == 0 && v_[1] == 0 && v_[2] == 0 && v_[3] == 0; }

 private:
  Vector v_;
};

}  // namespace lapidary
