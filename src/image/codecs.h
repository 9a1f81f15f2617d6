#pragma once

// Inside image/ only: what the formats share, and one reader and writer each.

#include <cstddef>
#include <functional>
#include <span>
#include <string>

#include "base/error.h"
#include "image/file_format.h"
#include "image/image.h"
#include "image/image_io.h"
#include "image/output_file.h"

namespace lapidary::image {

/// A file in memory, and how it is to be understood.
struct Source {
  std::string file;  ///< for messages
  std::span<const std::byte> bytes;
  ReadOptions options;
};

/// The error of a file that ends early or contradicts itself; `detail` in the library's words.
Error broken_file(const Source& source, FileFormat format, const std::string& detail);

/// Throws Error unless there are pixels, at most max_pixels and at most max_side in a row or
/// column.
void check_dimensions(const Source& source, std::uint64_t width, std::uint64_t height);

/// An image without pixels, and memory set aside for them. It is filled row by row, so a short
/// file that promises a gigantic picture costs address space and no memory.
Image reserved_image(int width, int height, int channels);

/// Light for each code from 0 to `largest`.
std::vector<float> code_table(int largest, ColorSpace color_space);

/// RGB rows of a picture that is being written, top row first.
struct RowSource {
  int width = 0;
  int height = 0;
  std::function<void(int y, std::span<float> rgb)> read;
};

/// Fills `codes` with the 8-bit RGB codes of row y; `scratch` holds 3 * width floats.
void encode_row(const RowSource& rows, int y, const Display& display, std::span<float> scratch,
                std::span<std::uint8_t> codes);

Image read_png(const Source& source);
Image read_jpeg(const Source& source);
Image read_radiance(const Source& source);
Image read_exr(const Source& source);
LayeredImage read_exr_layers(const Source& source);
std::optional<LayeredImage> read_exr_part(const Source& source, const std::string& name);

void write_png(OutputFile& out, const RowSource& rows, const WriteOptions& options);
void write_jpeg(OutputFile& out, const RowSource& rows, const WriteOptions& options);
void write_radiance(OutputFile& out, const RowSource& rows, const WriteOptions& options);
void write_exr(OutputFile& out, const Image& image, const WriteOptions& options);
void write_exr(OutputFile& out, const LayeredImage& image, const WriteOptions& options);
void write_exr(OutputFile& out, const LayeredImage& image, const Attachment& attachment,
               const WriteOptions& options);

}  // namespace lapidary::image
