#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/input_files.h"
#include "image/image.h"
#include "image/tone.h"

namespace lapidary::image {

/// The largest picture that is read: checked before memory is taken.
inline constexpr std::uint64_t max_pixels = std::uint64_t{1} << 28;
inline constexpr std::uint64_t max_side = std::uint64_t{1} << 20;

/// What the numbers in a file mean.
enum class ColorSpace {
  automatic,  ///< PNG and JPEG hold sRGB signals, Radiance and OpenEXR hold linear light
  linear,     ///< every file holds linear values: normal maps, roughness, masks
};

enum class Alpha {
  drop,  ///< three channels
  keep,  ///< four channels, the fourth is 1 where the file has no alpha
};

struct ReadOptions {
  ColorSpace color_space = ColorSpace::automatic;
  Alpha alpha = Alpha::drop;
  std::string layer;            ///< of an OpenEXR file; empty is the beauty, the channels R, G, B
  InputFiles* files = nullptr;  ///< where it is noted that the file was read; null: nowhere
};

/// Reads a picture as linear float RGB(A). The format follows from the content, not the name.
///
/// PNG: 1 to 16 bits, grey, palette, interlaced; gAMA and iCCP chunks are not looked at. JPEG:
/// grey and YCbCr. Radiance: RGBE, flat and both run-length codings, mantissas without the half
/// step, EXPOSURE not undone, as other renderers read it. OpenEXR: half, float and integer
/// channels, scan lines and tiles, the data window; of several parts the first that has the layer;
/// without R, G, B a luminance Y. Colours are left as stored, so they are straight beside a PNG's
/// alpha and multiplied with an OpenEXR's. NaN and infinity are kept: see count_non_finite.
/// Throws Error for anything that is not a whole picture within these limits.
Image read_image(const std::filesystem::path& path, const ReadOptions& options = {});

/// Reads the first part of an OpenEXR file with all its channels, sorted by name as in the file,
/// and those of its attributes that are text or numbers and not part of the format, sorted by name.
LayeredImage read_layers(const std::filesystem::path& path);

/// Reads the part of an OpenEXR file that has this name, whole; nothing where there is none.
/// Throws Error for a file that is no whole OpenEXR.
std::optional<LayeredImage> read_part(const std::filesystem::path& path, const std::string& name);

/// How an OpenEXR file is packed.
enum class Compression {
  zip,
  none,  ///< larger, and written several times as fast
};

/// What travels in the file of a picture as a second part, which viewers pass over: whole numbers
/// for each pixel, as many kinds of them as there are channels.
struct Attachment {
  struct Channel {
    std::string name;
    /// Fills row `y`.
    std::function<void(int y, std::span<std::uint32_t> row)> read;
  };
  std::string name;  ///< of the part
  int width = 0;
  int height = 0;
  std::vector<Channel> channels;
  Metadata metadata;
};

struct WriteOptions {
  Metadata metadata;  ///< for PNG, OpenEXR, Radiance; JPEG carries none
  Display display;    ///< for PNG and JPEG; the others hold the linear light itself
  Precision precision = Precision::half;       ///< of an OpenEXR file made from an Image
  Compression compression = Compression::zip;  ///< of an OpenEXR file
};

/// Writes linear light; the extension says the format (file_format.h).
///
/// PNG and JPEG (quality 92, no chroma subsampling) hold 8-bit sRGB codes, Radiance and OpenEXR
/// linear values. An image has 1 (grey), 3 or 4 (alpha, in OpenEXR only) channels. Radiance has no
/// negative numbers, which become 0, and no NaN, which become 0. The file appears complete or not
/// at all (output_file.h). Working memory is a few rows. Throws Error.
void write_image(const std::filesystem::path& path, const Image& image,
                 const WriteOptions& options = {});

/// Writes all layers to .exr (options.precision is not used: every channel has its own), the
/// beauty R, G, B to the others. The image's metadata come before those of the options.
/// Throws Error if a channel has not width * height samples, or names are empty or not unique.
void write_image(const std::filesystem::path& path, const LayeredImage& image,
                 const WriteOptions& options = {});

/// The same to .exr, with `attachment` as a second part: the first one, called "picture", is what
/// programs show that know nothing of the other.
void write_image(const std::filesystem::path& path, const LayeredImage& image,
                 const Attachment& attachment, const WriteOptions& options = {});

/// Throws the Error that `write_image` to this path would throw for its name, folder or
/// permissions; for calling before the hours of work whose result goes there. Leaves no trace.
void check_writable(const std::filesystem::path& path);

}  // namespace lapidary::image
