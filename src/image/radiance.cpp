#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "image/codecs.h"

// Radiance pictures, RGBE: three mantissas and one exponent of a byte each. Format: Greg Ward,
// "Real Pixels", Graphics Gems II, 1991; Radiance file formats, "Picture file format".

namespace lapidary::image {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// Rows outside these widths are never run-length coded by component.
constexpr int min_coded_width = 8;
constexpr int max_coded_width = 0x7FFF;

/// Walks through the bytes of the file; running out of them is the Error.
class Cursor {
 public:
  explicit Cursor(const Source& source) : source_(source), rest_(source.bytes) {}

  std::uint8_t byte() {
    if (rest_.empty()) fail("it ends early");
    const auto value = static_cast<std::uint8_t>(rest_[0]);
    rest_ = rest_.subspan(1);
    return value;
  }

  /// Up to a newline, which is taken and left out.
  std::string_view line() {
    const std::string_view text(reinterpret_cast<const char*>(rest_.data()), rest_.size());
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) fail("the header ends early");
    rest_ = rest_.subspan(end + 1);
    return text.substr(0, text.substr(0, end).ends_with('\r') ? end - 1 : end);
  }

  Rgbe rgbe() {
    Rgbe value;
    for (std::uint8_t& component : value) component = byte();
    return value;
  }

  [[noreturn]] void fail(const std::string& detail) const {
    throw broken_file(source_, FileFormat::radiance, detail);
  }

 private:
  const Source& source_;
  std::span<const std::byte> rest_;
};

/// How rows and pixels run in the file.
struct Layout {
  int width = 0;
  int height = 0;
  bool bottom_up = false;
  bool right_to_left = false;
};

std::uint32_t parsed_size(const Cursor& cursor, std::string_view text) {
  std::uint32_t size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error != std::errc() || end != text.data() + text.size()) {
    cursor.fail(fmt::format("'{}' is not a size", text));
  }
  return size;
}

/// The line "-Y height +X width", with either sign.
Layout parse_resolution(const Source& source, const Cursor& cursor, std::string_view line) {
  std::array<std::string_view, 4> words;
  for (std::string_view& word : words) {
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    line.remove_prefix(begin);
    word = line.substr(0, line.find(' '));
    line.remove_prefix(word.size());
  }
  if ((words[0] == "+X" || words[0] == "-X") && words[2].ends_with("Y")) {
    throw file_error(source.file, "is a Radiance file stored by columns, which is not read",
                     "rotate it by 90 degrees with another program");
  }
  const bool rows = words[0] == "-Y" || words[0] == "+Y";
  const bool columns = words[2] == "+X" || words[2] == "-X";
  if (!rows || !columns) cursor.fail("it has no line like '-Y 512 +X 1024'");
  const std::uint32_t height = parsed_size(cursor, words[1]);
  const std::uint32_t width = parsed_size(cursor, words[3]);
  check_dimensions(source, width, height);
  return {static_cast<int>(width), static_cast<int>(height), words[0] == "+Y", words[2] == "-X"};
}

Layout read_header(const Source& source, Cursor& cursor) {
  for (std::string_view line = cursor.line(); !line.empty(); line = cursor.line()) {
    if (line.starts_with("FORMAT=") && line != "FORMAT=32-bit_rle_rgbe") {
      throw file_error(source.file,
                       fmt::format("is a Radiance file of an unknown kind, '{}'", line.substr(7)),
                       "32-bit_rle_rgbe is read");
    }
  }
  return parse_resolution(source, cursor, cursor.line());
}

/// New run-length coding: each component of the row on its own.
void read_coded_row(Cursor& cursor, std::span<Rgbe> row) {
  for (std::size_t component = 0; component < 4; ++component) {
    std::size_t x = 0;
    while (x < row.size()) {
      const std::uint8_t code = cursor.byte();
      const std::size_t count = code > 128 ? code - 128u : code;
      if (count == 0 || count > row.size() - x) cursor.fail("a run leaves its row");
      const std::uint8_t repeated = code > 128 ? cursor.byte() : 0;
      for (std::size_t i = 0; i < count; ++i) {
        row[x++][component] = code > 128 ? repeated : cursor.byte();
      }
    }
  }
}

/// Flat pixels with old run-length coding: (1, 1, 1, n) repeats the pixel before n times, and
/// each such mark that follows at once counts 256 times as much.
void read_flat_row(Cursor& cursor, Rgbe first, std::span<Rgbe> row) {
  std::size_t x = 0;
  int shift = 0;
  for (Rgbe pixel = first;; pixel = cursor.rgbe()) {
    if (pixel[0] == 1 && pixel[1] == 1 && pixel[2] == 1) {
      if (x == 0 || shift > 16) cursor.fail("a run has no pixel to repeat");
      const std::size_t count = static_cast<std::size_t>(pixel[3]) << shift;
      if (count > row.size() - x) cursor.fail("a run leaves its row");
      std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(x), count, row[x - 1]);
      x += count;
      shift += 8;
    } else {
      row[x++] = pixel;
      shift = 0;
    }
    if (x == row.size()) return;
  }
}

void read_row(Cursor& cursor, std::span<Rgbe> row) {
  const Rgbe first = cursor.rgbe();
  const bool coded = first[0] == 2 && first[1] == 2 && first[2] < 128 &&
                     row.size() >= min_coded_width && row.size() <= max_coded_width;
  if (!coded) {
    read_flat_row(cursor, first, row);
    return;
  }
  if (first[2] * 256u + first[3] != row.size()) cursor.fail("a row has the wrong length");
  read_coded_row(cursor, row);
}

void append_row(std::span<const Rgbe> row, Image& image) {
  for (const Rgbe& pixel : row) {
    const float unit = pixel[3] == 0 ? 0.0f : std::ldexp(1.0f, pixel[3] - (128 + 8));
    for (std::size_t c = 0; c < 3; ++c) image.pixels.push_back(static_cast<float>(pixel[c]) * unit);
    if (image.channels == 4) image.pixels.push_back(1.0f);
  }
}

void flip_rows(Image& image) {
  for (int top = 0, bottom = image.height - 1; top < bottom; ++top, --bottom) {
    std::swap_ranges(image.row(top).begin(), image.row(top).end(), image.row(bottom).begin());
  }
}

/// The nearest of what the format can say.
Rgbe encoded(std::span<const float, 3> rgb) {
  constexpr float largest = 0x1.FEp+126f;  // 255 * 2^(255 - 136) is the largest there is
  std::array<float, 3> light;
  for (std::size_t c = 0; c < 3; ++c) light[c] = rgb[c] > 0 ? std::min(rgb[c], largest) : 0.0f;
  const float peak = *std::max_element(light.begin(), light.end());
  if (peak < 0x1p-127f) return {};
  int exponent = 0;
  std::frexp(peak, &exponent);
  // A peak that rounds up to 256 needs the next exponent.
  if (std::round(std::ldexp(peak, 8 - exponent)) > 255.0f) ++exponent;
  Rgbe value;
  for (std::size_t c = 0; c < 3; ++c) {
    value[c] = static_cast<std::uint8_t>(std::round(std::ldexp(light[c], 8 - exponent)));
  }
  value[3] = static_cast<std::uint8_t>(exponent + 128);
  return value;
}

std::size_t run_length(std::span<const Rgbe> row, std::size_t x, std::size_t component) {
  std::size_t end = x + 1;
  while (end < row.size() && end - x < 127 && row[end][component] == row[x][component]) ++end;
  return end - x;
}

/// One component of a row as runs of equal bytes, where at least four are, and literal bytes.
void append_coded(std::span<const Rgbe> row, std::size_t component,
                  std::vector<std::uint8_t>& bytes) {
  constexpr std::size_t min_run = 4;
  std::size_t x = 0;
  while (x < row.size()) {
    if (const std::size_t run = run_length(row, x, component); run >= min_run) {
      bytes.push_back(static_cast<std::uint8_t>(128 + run));
      bytes.push_back(row[x][component]);
      x += run;
      continue;
    }
    const std::size_t begin = x;
    while (x < row.size() && x - begin < 128 && run_length(row, x, component) < min_run) ++x;
    bytes.push_back(static_cast<std::uint8_t>(x - begin));
    for (std::size_t i = begin; i < x; ++i) bytes.push_back(row[i][component]);
  }
}

void append_row(std::span<const Rgbe> row, std::vector<std::uint8_t>& bytes) {
  if (row.size() < min_coded_width || row.size() > max_coded_width) {
    for (const Rgbe& pixel : row) bytes.insert(bytes.end(), pixel.begin(), pixel.end());
    return;
  }
  bytes.insert(bytes.end(), {2, 2, static_cast<std::uint8_t>(row.size() >> 8),
                             static_cast<std::uint8_t>(row.size() & 255)});
  for (std::size_t component = 0; component < 4; ++component) append_coded(row, component, bytes);
}

std::string header(const RowSource& rows, const Metadata& metadata) {
  std::string text = "#?RADIANCE\n";
  for (const Attribute& attribute : metadata) {
    std::string value = to_text(attribute);
    std::replace(value.begin(), value.end(), '\n', ' ');
    text += fmt::format("# {}: {}\n", attribute.name, value);
  }
  text += fmt::format("FORMAT=32-bit_rle_rgbe\n\n-Y {} +X {}\n", rows.height, rows.width);
  return text;
}

}  // namespace

Image read_radiance(const Source& source) {
  Cursor cursor(source);
  const Layout layout = read_header(source, cursor);
  Image image =
      reserved_image(layout.width, layout.height, source.options.alpha == Alpha::keep ? 4 : 3);
  std::vector<Rgbe> row(static_cast<std::size_t>(layout.width));
  for (int y = 0; y < layout.height; ++y) {
    read_row(cursor, row);
    if (layout.right_to_left) std::reverse(row.begin(), row.end());
    append_row(row, image);
  }
  if (layout.bottom_up) flip_rows(image);
  return image;
}

void write_radiance(OutputFile& out, const RowSource& rows, const WriteOptions& options) {
  const std::string text = header(rows, options.metadata);
  out.write(text.data(), text.size());
  std::vector<float> light(static_cast<std::size_t>(rows.width) * 3);
  std::vector<Rgbe> row(static_cast<std::size_t>(rows.width));
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < rows.height; ++y) {
    rows.read(y, light);
    for (std::size_t x = 0; x < row.size(); ++x) {
      row[x] = encoded(std::span<const float, 3>(light.data() + 3 * x, 3));
    }
    bytes.clear();
    append_row(row, bytes);
    out.write(bytes.data(), bytes.size());
  }
}

}  // namespace lapidary::image
