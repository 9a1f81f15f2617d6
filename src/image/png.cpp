#include <algorithm>
#include <cstring>
#include <exception>
#include <memory>

#include <png.h>

#include "image/codecs.h"

namespace lapidary::image {
namespace {

/// Half the time of the usual level 6 for 2 % larger files.
constexpr int compression_level = 4;

/// What libpng's callbacks know: it reports through them and then jumps.
struct Callbacks {
  std::string message;         ///< of the first error
  std::exception_ptr failure;  ///< that our own callback met, to be thrown on past libpng
  std::span<const std::byte> input;
  OutputFile* output = nullptr;
};

/// Calls `body`, which calls libpng; false if libpng gave up. The jump skips destructors, so
/// `body` must own nothing.
template <typename Body>
bool completes(png_structp png, const Body& body) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  body();
  return true;
}

extern "C" {
static void png_on_error(png_structp png, png_const_charp message) {
  static_cast<Callbacks*>(png_get_error_ptr(png))->message = message;
  png_longjmp(png, 1);
}

static void png_on_warning(png_structp, png_const_charp) {}

static void png_on_read(png_structp png, png_bytep data, std::size_t size) {
  auto& input = static_cast<Callbacks*>(png_get_io_ptr(png))->input;
  if (size > input.size()) png_error(png, "it ends early");
  std::memcpy(data, input.data(), size);
  input = input.subspan(size);
}

static void png_on_write(png_structp png, png_bytep data, std::size_t size) {
  auto& callbacks = *static_cast<Callbacks*>(png_get_io_ptr(png));
  try {
    callbacks.output->write(data, size);
  } catch (...) {
    callbacks.failure = std::current_exception();
  }
  if (callbacks.failure) png_error(png, "write failed");
}

static void png_on_flush(png_structp) {}
}

struct Reader {
  Callbacks callbacks;
  png_structp png = nullptr;
  png_infop info = nullptr;

  Reader() {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &callbacks, png_on_error, png_on_warning);
    if (png) info = png_create_info_struct(png);
    if (!info) {
      png_destroy_read_struct(&png, &info, nullptr);
      throw std::bad_alloc();
    }
    png_set_read_fn(png, &callbacks, png_on_read);
  }
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
};

struct Writer {
  Callbacks callbacks;
  png_structp png = nullptr;
  png_infop info = nullptr;

  Writer() {
    png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &callbacks, png_on_error, png_on_warning);
    if (png) info = png_create_info_struct(png);
    if (!info) {
      png_destroy_write_struct(&png, &info);
      throw std::bad_alloc();
    }
    png_set_write_fn(png, &callbacks, png_on_write, png_on_flush);
  }
  ~Writer() { png_destroy_write_struct(&png, &info); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
};

/// Asks libpng for RGB or RGBA in 8 or 16 bits whatever the file has.
void request_rgb(const Reader& reader, Alpha alpha) {
  png_set_palette_to_rgb(reader.png);
  png_set_expand_gray_1_2_4_to_8(reader.png);
  png_set_gray_to_rgb(reader.png);
  if (alpha == Alpha::drop) {
    png_set_strip_alpha(reader.png);
    return;
  }
  const bool has_alpha = (png_get_color_type(reader.png, reader.info) & PNG_COLOR_MASK_ALPHA) != 0;
  if (png_get_valid(reader.png, reader.info, PNG_INFO_tRNS) != 0) {
    png_set_tRNS_to_alpha(reader.png);
  } else if (!has_alpha) {
    png_set_add_alpha(reader.png, 0xFFFF, PNG_FILLER_AFTER);
  }
}

/// Turns rows of codes, 16-bit ones with the high byte first, into light.
class RowDecoder {
 public:
  RowDecoder(int bit_depth, int channels, ColorSpace color_space)
      : wide_(bit_depth == 16),
        channels_(static_cast<std::size_t>(channels)),
        light_(code_table(wide_ ? 65535 : 255, color_space)) {}

  void append(const png_byte* codes, Image& image) const {
    const std::size_t count = static_cast<std::size_t>(image.width) * channels_;
    const float alpha_scale = 1.0f / static_cast<float>(light_.size() - 1);
    for (std::size_t i = 0; i < count; ++i) {
      const unsigned code = wide_ ? codes[2 * i] * 256u + codes[2 * i + 1] : codes[i];
      const bool alpha = i % channels_ == 3;
      image.pixels.push_back(alpha ? static_cast<float>(code) * alpha_scale : light_[code]);
    }
  }

 private:
  bool wide_;
  std::size_t channels_;
  std::vector<float> light_;
};

void read_rows(const Reader& reader, const RowDecoder& decoder, png_byte* buffer, Image& image) {
  const int passes = png_set_interlace_handling(reader.png);
  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  // An interlaced picture is complete only after its last pass, so all of it is in the buffer.
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
      png_byte* row = passes == 1 ? buffer : buffer + y * row_bytes;
      png_read_row(reader.png, row, nullptr);
      if (pass == passes - 1) decoder.append(row, image);
    }
  }
  png_read_end(reader.png, nullptr);
}

void set_texts(const Writer& writer, const Metadata& metadata) {
  for (const Attribute& attribute : metadata) {
    std::string value = to_text(attribute);
    const bool ascii = std::all_of(value.begin(), value.end(), [](char c) { return c >= 0; });
    std::string name = attribute.name;
    png_text text{};
    text.compression = ascii ? PNG_TEXT_COMPRESSION_NONE : PNG_ITXT_COMPRESSION_NONE;
    text.key = name.data();
    text.text = value.data();
    text.text_length = value.size();
    png_set_text(writer.png, writer.info, &text, 1);
  }
}

}  // namespace

Image read_png(const Source& source) {
  Reader reader;
  reader.callbacks.input = source.bytes;
  const auto require = [&](bool completed) {
    if (!completed) throw broken_file(source, FileFormat::png, reader.callbacks.message);
  };
  require(completes(reader.png, [&] {
    png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);  // ours come next
    // Only what makes the pixels: libpng takes memory for whatever length a text claims.
    png_set_keep_unknown_chunks(reader.png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    png_read_info(reader.png, reader.info);
  }));
  const auto width = png_get_image_width(reader.png, reader.info);
  const auto height = png_get_image_height(reader.png, reader.info);
  check_dimensions(source, width, height);
  require(completes(reader.png, [&] {
    request_rgb(reader, source.options.alpha);
    png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
  }));

  const int channels = png_get_channels(reader.png, reader.info);
  const bool interlaced = png_get_interlace_type(reader.png, reader.info) != PNG_INTERLACE_NONE;
  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  const auto buffer = std::make_unique_for_overwrite<png_byte[]>(
      row_bytes * (interlaced ? std::size_t{height} : 1));
  const RowDecoder decoder(png_get_bit_depth(reader.png, reader.info), channels,
                           source.options.color_space);
  Image image = reserved_image(static_cast<int>(width), static_cast<int>(height), channels);
  require(completes(reader.png, [&] { read_rows(reader, decoder, buffer.get(), image); }));
  return image;
}

void write_png(OutputFile& out, const RowSource& rows, const WriteOptions& options) {
  Writer writer;
  writer.callbacks.output = &out;
  set_texts(writer, options.metadata);
  std::vector<float> light(static_cast<std::size_t>(rows.width) * 3);
  std::vector<std::uint8_t> codes(light.size());
  const bool completed = completes(writer.png, [&] {
    png_set_user_limits(writer.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(rows.width),
                 static_cast<png_uint_32>(rows.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(writer.png, writer.info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(writer.png, compression_level);
    png_write_info(writer.png, writer.info);
    for (int y = 0; y < rows.height; ++y) {
      encode_row(rows, y, options.display, light, codes);
      png_write_row(writer.png, codes.data());
    }
    png_write_end(writer.png, writer.info);
  });
  if (writer.callbacks.failure) std::rethrow_exception(writer.callbacks.failure);
  if (!completed) throw file_error(out.path().string(), writer.callbacks.message);
}

}  // namespace lapidary::image
