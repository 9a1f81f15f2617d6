#include <algorithm>
#include <array>
#include <cmath>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticities.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <fmt/format.h>

#include "image/codecs.h"
#include "image/exr_names.h"
#include "image/exr_stream.h"

namespace lapidary::image {
namespace {

/// Rows that are handed over at once: those that ZIP compresses together.
constexpr int block_rows = 16;

/// One channel in memory: 32-bit samples, `stride` of them from one pixel to the next.
struct Plane {
  std::string name;
  Imf::PixelType type;
  const void* samples;
  std::size_t stride;
};

/// Finite values stay finite.
half to_half(float value) {
  const float limit = HALF_MAX;
  return half(std::isfinite(value) ? std::clamp(value, -limit, limit) : value);
}

void add_metadata(Imf::Header& header, const std::string& file, const Metadata& metadata) {
  for (const Attribute& attribute : metadata) {
    if (is_reserved_exr_name(attribute.name)) {
      throw file_error(
          file, fmt::format("the metadata name '{}' belongs to OpenEXR itself", attribute.name),
          "choose another name");
    }
    if (const auto* text = std::get_if<std::string>(&attribute.value)) {
      header.insert(attribute.name, Imf::StringAttribute(*text));
    } else {
      header.insert(attribute.name, Imf::DoubleAttribute(std::get<double>(attribute.value)));
    }
  }
}

/// Hands the planes to OpenEXR in blocks of rows, each converted just before.
class PlaneWriter {
 public:
  PlaneWriter(int width, std::span<const Plane> planes) : width_(width), planes_(planes) {
    halves_.resize(planes.size());
    for (std::size_t i = 0; i < planes.size(); ++i) {
      if (planes[i].type == Imf::HALF)
        halves_[i].resize(static_cast<std::size_t>(width) * block_rows);
    }
  }

  /// To an OutputFile or an OutputPart.
  template <typename Out>
  void write(Out& out, int height) {
    for (int y = 0; y < height; y += block_rows) {
      const int rows = std::min(block_rows, height - y);
      Imf::FrameBuffer frame;
      for (std::size_t i = 0; i < planes_.size(); ++i) {
        frame.insert(planes_[i].name, slice(i, y, rows));
      }
      out.setFrameBuffer(frame);
      out.writePixels(rows);
    }
  }

 private:
  Imf::Slice slice(std::size_t index, int y, int rows) {
    const Plane& plane = planes_[index];
    const std::size_t pixel_bytes = plane.stride * 4;
    const std::size_t first = static_cast<std::size_t>(y) * width_ * pixel_bytes;
    const void* samples = static_cast<const char*>(plane.samples) + first;
    if (plane.type != Imf::HALF) {
      return Imf::Slice::Make(plane.type, samples, Imath::V2i(0, y), width_, rows, pixel_bytes);
    }
    const auto* values = static_cast<const float*>(samples);
    const std::size_t count = static_cast<std::size_t>(width_) * rows;
    for (std::size_t i = 0; i < count; ++i) halves_[index][i] = to_half(values[i * plane.stride]);
    return Imf::Slice::Make(Imf::HALF, halves_[index].data(), Imath::V2i(0, y), width_, rows);
  }

  int width_;
  std::span<const Plane> planes_;
  std::vector<std::vector<half>> halves_;
};

Imf::Header header_of(const OutputFile& out, int width, int height, const WriteOptions& options) {
  Imf::Header header(width, height);
  header.compression() =
      options.compression == Compression::zip ? Imf::ZIP_COMPRESSION : Imf::NO_COMPRESSION;
  Imf::addChromaticities(header, Imf::Chromaticities());  // Rec. 709 with D65 is the default
  add_metadata(header, out.path().string(), options.metadata);
  return header;
}

void add_channels(Imf::Header& header, std::span<const Plane> planes) {
  for (const Plane& plane : planes) header.channels().insert(plane.name, Imf::Channel(plane.type));
}

/// `write(stream)` with OpenEXR's exceptions as Error.
template <typename Write>
void write_stream(OutputFile& out, const Write& write) {
  FileStream stream(out);
  try {
    write(stream);
  } catch (const Iex::BaseExc& failure) {
    stream.rethrow();
    throw file_error(out.path().string(), fmt::format("could not be written: {}", failure.what()));
  }
  stream.rethrow();
}

void write_planes(OutputFile& out, int width, int height, std::span<const Plane> planes,
                  const WriteOptions& options) {
  Imf::Header header = header_of(out, width, height, options);
  add_channels(header, planes);
  write_stream(out, [&](FileStream& stream) {
    // No threads: whoever calls has its own, and the bytes are to be the same for any number.
    Imf::OutputFile exr(stream, header, 0);
    PlaneWriter(width, planes).write(exr, height);
  });
}

void write_attachment(Imf::OutputPart& part, const Attachment& attachment) {
  const auto width = static_cast<std::size_t>(attachment.width);
  std::vector<std::vector<std::uint32_t>> blocks(attachment.channels.size());
  for (auto& block : blocks) block.resize(width * block_rows);
  for (int y = 0; y < attachment.height; y += block_rows) {
    const int rows = std::min(block_rows, attachment.height - y);
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < blocks.size(); ++c) {
      for (int row = 0; row < rows; ++row) {
        attachment.channels[c].read(
            y + row, std::span(blocks[c]).subspan(static_cast<std::size_t>(row) * width, width));
      }
      frame.insert(
          attachment.channels[c].name,
          Imf::Slice::Make(Imf::UINT, blocks[c].data(), Imath::V2i(0, y), attachment.width, rows));
    }
    part.setFrameBuffer(frame);
    part.writePixels(rows);
  }
}

Plane plane_of(const Channel& channel) {
  if (const auto* integers = std::get_if<std::vector<std::uint32_t>>(&channel.samples)) {
    return {channel.name, Imf::UINT, integers->data(), 1};
  }
  const Imf::PixelType type = channel.precision == Precision::half ? Imf::HALF : Imf::FLOAT;
  return {channel.name, type, std::get<std::vector<float>>(channel.samples).data(), 1};
}

std::vector<Plane> planes_of(const LayeredImage& image) {
  std::vector<Plane> planes;
  for (const Channel& channel : image.channels) planes.push_back(plane_of(channel));
  return planes;
}

}  // namespace

void write_exr(OutputFile& out, const Image& image, const WriteOptions& options) {
  const std::vector<std::string> names = image.channels == 1
                                             ? std::vector<std::string>{"Y"}
                                             : std::vector<std::string>{"R", "G", "B", "A"};
  const Imf::PixelType type = options.precision == Precision::half ? Imf::HALF : Imf::FLOAT;
  std::vector<Plane> planes;
  for (std::size_t c = 0; c < static_cast<std::size_t>(image.channels); ++c) {
    planes.push_back(
        {names[c], type, image.pixels.data() + c, static_cast<std::size_t>(image.channels)});
  }
  write_planes(out, image.width, image.height, planes, options);
}

void write_exr(OutputFile& out, const LayeredImage& image, const WriteOptions& options) {
  write_planes(out, image.width, image.height, planes_of(image), options);
}

void write_exr(OutputFile& out, const LayeredImage& image, const Attachment& attachment,
               const WriteOptions& options) {
  const std::vector<Plane> planes = planes_of(image);
  Imf::Header picture = header_of(out, image.width, image.height, options);
  add_channels(picture, planes);
  picture.setName("picture");
  WriteOptions attached = options;
  attached.metadata = attachment.metadata;
  Imf::Header second = header_of(out, attachment.width, attachment.height, attached);
  for (const Attachment::Channel& channel : attachment.channels) {
    second.channels().insert(channel.name, Imf::Channel(Imf::UINT));
  }
  second.setName(attachment.name);
  std::array<Imf::Header, 2> headers = {picture, second};
  for (Imf::Header& header : headers) header.setType(Imf::SCANLINEIMAGE);
  write_stream(out, [&](FileStream& stream) {
    Imf::MultiPartOutputFile exr(stream, headers.data(), 2, false, 0);
    Imf::OutputPart first_part(exr, 0), second_part(exr, 1);
    PlaneWriter(image.width, planes).write(first_part, image.height);
    write_attachment(second_part, attachment);
  });
}

}  // namespace lapidary::image
