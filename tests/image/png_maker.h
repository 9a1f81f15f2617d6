#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace lapidary::image::test {

/// PNG files of kinds that the project does not write, put together from the specification
/// (W3C PNG, second edition) with uncompressed deflate blocks (RFC 1950, 1951).
namespace png {

inline std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift);
  return bytes;
}

inline std::string chunk(const std::string& type, const std::string& data) {
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char c : type + data) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0u);
  }
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(~crc);
}

/// `data` of less than 64 KiB.
inline std::string zlib(const std::string& data) {
  std::uint32_t a = 1, b = 0;
  for (const char c : data) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const auto size = static_cast<std::uint16_t>(data.size());
  std::string bytes = {'\x78', '\x01', '\x01'};
  for (const int part : {size & 255, size >> 8, ~size & 255, (~size >> 8) & 255}) {
    bytes += static_cast<char>(part);
  }
  return bytes + data + big_endian(b << 16 | a);
}

enum ColorType : char { grey = 0, rgb = 2, palette = 3, grey_alpha = 4, rgb_alpha = 6 };

struct Header {
  std::uint32_t width;
  std::uint32_t height;
  char depth;
  ColorType type;
  char interlace = 0;
};

inline std::string header_chunk(const Header& header) {
  return chunk("IHDR", big_endian(header.width) + big_endian(header.height) + header.depth +
                           static_cast<char>(header.type) + '\0' + '\0' + header.interlace);
}

/// `rows`: each row's bytes, in the order of the passes if interlaced; filter 0 is added.
inline std::string file(const Header& header, const std::string& chunks_before_data,
                        const std::vector<std::string>& rows) {
  std::string data;
  for (const std::string& row : rows) data += '\0' + row;
  return "\x89PNG\r\n\x1a\n" + header_chunk(header) + chunks_before_data +
         chunk("IDAT", zlib(data)) + chunk("IEND", "");
}

}  // namespace png
}  // namespace lapidary::image::test
