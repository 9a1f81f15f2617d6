#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <variant>
#include <vector>

namespace lapidary::texture {

/// The values of the 256 codes of an 8-bit picture.
class ByteScale {
 public:
  static const ByteScale& srgb();
  static const ByteScale& linear();

  float value(std::uint8_t code) const { return values_[code]; }
  const float* values() const { return values_.data(); }
  /// The code of the nearest signal; of 0 and 255 for what is beyond.
  std::uint8_t nearest(float value) const;

 private:
  explicit ByteScale(float (*decode)(float));

  static constexpr int buckets = 4096;
  std::array<float, 256> values_;
  std::array<float, 256> limits_;  ///< of what is still the code
  std::array<std::uint8_t, buckets + 1> first_;
};

/// Numbers in less memory: one byte each where all are values of one byte scale, so that nothing is
/// lost of an 8-bit picture, else half floats, whose greatest is 65504.
class Texels {
 public:
  static constexpr std::size_t line = 64;  ///< bytes that memory comes in; stores begin with one

  template <typename T>
  struct LineAllocator {
    using value_type = T;
    T* allocate(std::size_t n) {
      return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{line}));
    }
    void deallocate(T* p, std::size_t n) {
      ::operator delete (p, n * sizeof(T), std::align_val_t{line});
    }
    bool operator==(const LineAllocator&) const = default;
  };
  struct Bytes {
    std::vector<std::uint8_t, LineAllocator<std::uint8_t>> codes;
    const ByteScale* scale;
  };
  struct Halves {
    std::vector<std::uint16_t, LineAllocator<std::uint16_t>> bits;
  };

  /// Has none yet; made for `count` values such as `like`.
  Texels(std::span<const float> like, std::size_t count);

  /// Values that are none of the scale become those of the nearest code. Precondition: no more than
  /// `count` altogether.
  void append(std::span<const float> values);
  std::size_t bytes() const;
  /// Three numbers more than `count` can be read, so that four can be loaded at any.
  const std::variant<Bytes, Halves>& store() const { return store_; }

 private:
  std::variant<Bytes, Halves> store_;
  std::size_t used_ = 0;
};

}  // namespace lapidary::texture
