#include <csetjmp>
#include <cstdio>

// After <cstdio>, which jpeglib.h needs and does not include.
#include <array>
#include <exception>

#include <jerror.h>
#include <jpeglib.h>

#include "image/codecs.h"

namespace lapidary::image {
namespace {

constexpr int quality = 92;
/// Far more than any encoder makes; each costs a walk over the whole picture.
constexpr int max_scans = 200;

/// libjpeg's error handler, which must not return; it jumps to `escape`.
struct ErrorHandler {
  jpeg_error_mgr base;  ///< first, so that a pointer to it is a pointer to this
  std::jmp_buf escape;
  std::array<char, JMSG_LENGTH_MAX> message;
};

ErrorHandler& handler_of(j_common_ptr jpeg) {
  return *reinterpret_cast<ErrorHandler*>(jpeg->err);
}

/// Calls `body`, which calls libjpeg; false if libjpeg gave up. The jump skips destructors, so
/// `body` must own nothing.
template <typename Body>
bool completes(ErrorHandler& handler, const Body& body) {
  if (setjmp(handler.escape) != 0) return false;
  body();
  return true;
}

/// Collects output and passes it on in large pieces.
struct Destination {
  jpeg_destination_mgr base;  ///< first, as above
  OutputFile* out;
  std::exception_ptr failure;
  std::array<JOCTET, 1 << 16> buffer;
};

extern "C" {
static void jpeg_on_error(j_common_ptr jpeg) {
  ErrorHandler& handler = handler_of(jpeg);
  handler.base.format_message(jpeg, handler.message.data());
  std::longjmp(handler.escape, 1);
}

/// libjpeg paints grey over what is missing and calls it a warning; here that is an error.
static void jpeg_on_message(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  switch (jpeg->err->msg_code) {
    case JWRN_JPEG_EOF:
    case JWRN_HIT_MARKER:
    case JWRN_HUFF_BAD_CODE:
    case JWRN_MUST_RESYNC:
    case JWRN_BOGUS_PROGRESSION:
      jpeg_on_error(jpeg);
      break;
    default:
      break;
  }
}

static void jpeg_on_progress(j_common_ptr jpeg) {
  auto* decoder = reinterpret_cast<j_decompress_ptr>(jpeg);
  if (decoder->input_scan_number <= max_scans) return;
  ErrorHandler& handler = handler_of(jpeg);
  std::snprintf(handler.message.data(), handler.message.size(), "it has more than %d scans",
                max_scans);
  std::longjmp(handler.escape, 1);
}

static void jpeg_start_output(j_compress_ptr jpeg) {
  auto& destination = *reinterpret_cast<Destination*>(jpeg->dest);
  destination.base.next_output_byte = destination.buffer.data();
  destination.base.free_in_buffer = destination.buffer.size();
}

static void jpeg_pass_on(j_compress_ptr jpeg, std::size_t size) {
  auto& destination = *reinterpret_cast<Destination*>(jpeg->dest);
  try {
    destination.out->write(destination.buffer.data(), size);
  } catch (...) {
    destination.failure = std::current_exception();
  }
  if (destination.failure) ERREXIT(jpeg, JERR_FILE_WRITE);
}

static boolean jpeg_on_full_buffer(j_compress_ptr jpeg) {
  jpeg_pass_on(jpeg, reinterpret_cast<Destination*>(jpeg->dest)->buffer.size());
  jpeg_start_output(jpeg);
  return TRUE;
}

static void jpeg_end_output(j_compress_ptr jpeg) {
  auto& destination = *reinterpret_cast<Destination*>(jpeg->dest);
  jpeg_pass_on(jpeg, destination.buffer.size() - destination.base.free_in_buffer);
}
}

void install(ErrorHandler& handler, jpeg_error_mgr*& slot) {
  slot = jpeg_std_error(&handler.base);
  handler.base.error_exit = jpeg_on_error;
  handler.base.emit_message = jpeg_on_message;
  handler.message[0] = '\0';
}

struct Decoder {
  ErrorHandler handler{};
  jpeg_progress_mgr progress{};
  jpeg_decompress_struct jpeg{};

  Decoder() {
    install(handler, jpeg.err);
    if (!completes(handler, [&] { jpeg_create_decompress(&jpeg); })) throw std::bad_alloc();
    progress.progress_monitor = jpeg_on_progress;
    jpeg.progress = &progress;
  }
  ~Decoder() { jpeg_destroy_decompress(&jpeg); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
};

struct Encoder {
  ErrorHandler handler{};
  Destination destination{};
  jpeg_compress_struct jpeg{};

  explicit Encoder(OutputFile& out) {
    install(handler, jpeg.err);
    if (!completes(handler, [&] { jpeg_create_compress(&jpeg); })) throw std::bad_alloc();
    destination.out = &out;
    destination.base.init_destination = jpeg_start_output;
    destination.base.empty_output_buffer = jpeg_on_full_buffer;
    destination.base.term_destination = jpeg_end_output;
    jpeg.dest = &destination.base;
  }
  ~Encoder() { jpeg_destroy_compress(&jpeg); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;
};

void append_row(std::span<const JSAMPLE> codes, const std::vector<float>& light, Image& image) {
  for (std::size_t i = 0; i < codes.size(); ++i) {
    image.pixels.push_back(light[codes[i]]);
    if (image.channels == 4 && i % 3 == 2) image.pixels.push_back(1.0f);
  }
}

}  // namespace

Image read_jpeg(const Source& source) {
  Decoder decoder;
  jpeg_decompress_struct& jpeg = decoder.jpeg;
  const auto require = [&](bool completed) {
    if (!completed) throw broken_file(source, FileFormat::jpeg, decoder.handler.message.data());
  };
  require(completes(decoder.handler, [&] {
    jpeg_mem_src(&jpeg, reinterpret_cast<const unsigned char*>(source.bytes.data()),
                 static_cast<unsigned long>(source.bytes.size()));
    jpeg_read_header(&jpeg, TRUE);
  }));
  check_dimensions(source, jpeg.image_width, jpeg.image_height);
  if (jpeg.jpeg_color_space == JCS_CMYK || jpeg.jpeg_color_space == JCS_YCCK) {
    throw file_error(source.file, "is a JPEG file in CMYK, for print", "convert it to RGB");
  }

  const int channels = source.options.alpha == Alpha::keep ? 4 : 3;
  const std::vector<float> light = code_table(255, source.options.color_space);
  Image image = reserved_image(static_cast<int>(jpeg.image_width),
                               static_cast<int>(jpeg.image_height), channels);
  std::vector<JSAMPLE> codes(static_cast<std::size_t>(image.width) * 3);
  require(completes(decoder.handler, [&] {
    jpeg.out_color_space = JCS_RGB;
    jpeg_start_decompress(&jpeg);
    while (jpeg.output_scanline < jpeg.output_height) {
      JSAMPROW row = codes.data();
      jpeg_read_scanlines(&jpeg, &row, 1);
      append_row(codes, light, image);
    }
    jpeg_finish_decompress(&jpeg);
  }));
  return image;
}

void write_jpeg(OutputFile& out, const RowSource& rows, const WriteOptions& options) {
  Encoder encoder(out);
  jpeg_compress_struct& jpeg = encoder.jpeg;
  std::vector<float> light(static_cast<std::size_t>(rows.width) * 3);
  std::vector<std::uint8_t> codes(light.size());
  const bool completed = completes(encoder.handler, [&] {
    jpeg.image_width = static_cast<JDIMENSION>(rows.width);
    jpeg.image_height = static_cast<JDIMENSION>(rows.height);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, quality, TRUE);
    jpeg.comp_info[0].h_samp_factor = 1;
    jpeg.comp_info[0].v_samp_factor = 1;
    jpeg_start_compress(&jpeg, TRUE);
    for (int y = 0; y < rows.height; ++y) {
      encode_row(rows, y, options.display, light, codes);
      JSAMPROW row = codes.data();
      jpeg_write_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_compress(&jpeg);
  });
  if (encoder.destination.failure) std::rethrow_exception(encoder.destination.failure);
  if (!completed) throw file_error(out.path().string(), encoder.handler.message.data());
}

}  // namespace lapidary::image
