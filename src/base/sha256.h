#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace lapidary {

/// The SHA-256 of what it is given, piece by piece: what the program `sha256sum` prints.
/// Source: NIST FIPS 180-4, sections 4.1.2, 5 and 6.2.
class Sha256 {
 public:
  using Digest = std::array<std::uint8_t, 32>;

  void add(std::span<const std::byte> bytes);
  /// Of everything added; afterwards nothing may be added.
  Digest finish();

 private:
  void add_block(const std::byte* bytes);

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::byte, 64> rest_{};  ///< what is no whole block yet
  std::uint64_t size_ = 0;            ///< in bytes
};

/// 64 hexadecimal digits.
std::string to_text(const Sha256::Digest& digest);

}  // namespace lapidary
