#include <algorithm>
#include <optional>
#include <string_view>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfVersion.h>
#include <fmt/format.h>

#include "image/codecs.h"
#include "image/exr_names.h"
#include "image/exr_stream.h"

namespace lapidary::image {
namespace {

/// Pixels that are decoded at once, in whole rows: little, because a broken file may have no more.
constexpr int block_pixels = 1 << 18;

struct Window {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// The data window of a header, checked.
Window window_of(const Source& source, const Imf::Header& header) {
  const Imath::Box2i& box = header.dataWindow();
  const std::int64_t width = std::int64_t{box.max.x} - box.min.x + 1;
  const std::int64_t height = std::int64_t{box.max.y} - box.min.y + 1;
  if (width < 1 || height < 1) throw file_error(source.file, "is a picture without pixels");
  check_dimensions(source, static_cast<std::uint64_t>(width), static_cast<std::uint64_t>(height));
  return {box.min.x, box.min.y, static_cast<int>(width), static_cast<int>(height)};
}

/// Walks over the attributes of a header: name, type, size and value of each.
void check_attributes(const Source& source, std::uint64_t at) {
  const std::string_view bytes(reinterpret_cast<const char*>(source.bytes.data()),
                               source.bytes.size());
  while (at < bytes.size() && bytes[at] != '\0') {
    at = bytes.find('\0', at);
    if (at < bytes.size()) at = bytes.find('\0', at + 1);
    if (at >= bytes.size() || bytes.size() - at < 5) throw Iex::InputExc("the header ends early");
    std::int32_t size = 0;
    std::memcpy(&size, bytes.data() + at + 1, 4);
    at += 5;
    if (size < 0 || static_cast<std::uint64_t>(size) > bytes.size() - at) {
      throw Iex::InputExc("an attribute is longer than the file");
    }
    at += static_cast<std::uint64_t>(size);
  }
}

/// Looks at all sizes before OpenEXR's own reader, which takes memory for them at once.
void check_headers(const Source& source) {
  MemoryStream stream(source);
  char start[8];
  stream.read(start, 8);
  int version = 0;
  std::memcpy(&version, start + 4, 4);
  const bool many = Imf::isMultiPart(version);
  for (;;) {
    const std::uint64_t begin = stream.tellg();
    if (many && begin < source.bytes.size() && source.bytes[begin] == std::byte{0}) return;
    check_attributes(source, begin);
    Imf::Header header;
    header.readFrom(stream, version);
    window_of(source, header);
    if (!many) return;
  }
}

bool is_deep(const Imf::Header& header) {
  return header.hasType() && Imf::isDeepData(header.type());
}

void check_samplings(const Source& source, const Imf::Header& header) {
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
    if (i.channel().xSampling != 1 || i.channel().ySampling != 1) {
      throw file_error(
          source.file,
          fmt::format("its channel {} has fewer samples than pixels, which is not read", i.name()),
          "save it as RGB");
    }
  }
}

/// Where a picture's light is: a part and the names of its channels there.
struct Place {
  int part = 0;
  std::vector<std::string> names;  ///< one for Y, three for R, G, B
  std::string alpha;
};

std::optional<Place> place_in(const Imf::MultiPartInputFile& file, const std::string& prefix,
                              std::span<const std::string_view> components) {
  for (int part = 0; part < file.parts(); ++part) {
    if (is_deep(file.header(part))) continue;
    Place place{part, {}, prefix + "A"};
    for (const std::string_view component : components) {
      place.names.push_back(prefix + std::string(component));
    }
    const Imf::ChannelList& channels = file.header(part).channels();
    if (std::all_of(place.names.begin(), place.names.end(),
                    [&](const std::string& name) { return channels.findChannel(name); })) {
      return place;
    }
  }
  return std::nullopt;
}

std::string channel_names(const Imf::MultiPartInputFile& file) {
  constexpr std::size_t longest = 300;
  std::string text;
  for (int part = 0; part < file.parts(); ++part) {
    const Imf::ChannelList& channels = file.header(part).channels();
    for (auto i = channels.begin(); i != channels.end(); ++i) {
      if (text.size() > longest) return text + ", ...";
      text += fmt::format("{}{}", text.empty() ? "" : ", ", i.name());
    }
  }
  return text;
}

Place find_layer(const Source& source, const Imf::MultiPartInputFile& file) {
  constexpr std::string_view color[] = {"R", "G", "B"};
  constexpr std::string_view grey[] = {"Y"};
  const std::string& layer = source.options.layer;
  const std::string prefix = layer.empty() ? "" : layer + ".";
  if (const auto place = place_in(file, prefix, color)) return *place;
  if (const auto place = place_in(file, prefix, grey)) return *place;
  throw file_error(source.file,
                   layer.empty() ? "has no channels R, G, B and no Y"
                                 : fmt::format("has no layer '{}' of R, G, B or Y", layer),
                   fmt::format("it has {}", channel_names(file)));
}

/// Calls `frame(y, rows)` for the frame buffer of each block of rows, and reads it.
template <typename MakeFrame>
void read_blocks(Imf::InputPart& part, const Window& window, const MakeFrame& frame) {
  const int block_rows = std::max(1, block_pixels / window.width);
  for (int y = 0; y < window.height; y += block_rows) {
    const int rows = std::min(block_rows, window.height - y);
    part.setFrameBuffer(frame(y, rows));
    part.readPixels(window.y + y, window.y + y + rows - 1);
  }
}

Image read_place(Imf::MultiPartInputFile& file, const Window& window, const Place& place,
                 Alpha alpha) {
  const std::size_t channels = alpha == Alpha::keep ? 4 : 3;
  Image image = reserved_image(window.width, window.height, static_cast<int>(channels));
  Imf::InputPart part(file, place.part);
  read_blocks(part, window, [&](int y, int rows) {
    const std::size_t begin = image.pixels.size();
    image.pixels.resize(begin + static_cast<std::size_t>(window.width) * rows * channels);
    const auto slice = [&](std::size_t component) {
      return Imf::Slice::Make(Imf::FLOAT, image.pixels.data() + begin + component,
                              Imath::V2i(window.x, window.y + y), window.width, rows,
                              channels * sizeof(float), channels * sizeof(float) * window.width, 1,
                              1, 1.0);
    };
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < place.names.size(); ++c) frame.insert(place.names[c], slice(c));
    // OpenEXR fills a slice whose channel the file does not have, here with 1.
    if (channels == 4) frame.insert(place.alpha, slice(3));
    return frame;
  });
  if (place.names.size() == 1) {
    for (std::size_t at = 0; at < image.pixels.size(); at += channels) {
      image.pixels[at + 1] = image.pixels[at + 2] = image.pixels[at];
    }
  }
  return image;
}

Channel empty_channel(const char* name, Imf::PixelType type, std::size_t pixels) {
  Channel channel{name, {}, type == Imf::HALF ? Precision::half : Precision::full};
  if (type == Imf::UINT) channel.samples = std::vector<std::uint32_t>();
  std::visit([&](auto& samples) { samples.reserve(pixels); }, channel.samples);
  return channel;
}

/// Makes room for the rows [y, y + rows) of one channel.
Imf::Slice grown_slice(Channel& channel, const Window& window, int y, int rows) {
  return std::visit(
      [&](auto& samples) {
        const std::size_t begin = samples.size();
        samples.resize(begin + static_cast<std::size_t>(window.width) * rows);
        const bool integer = std::holds_alternative<std::vector<std::uint32_t>>(channel.samples);
        return Imf::Slice::Make(integer ? Imf::UINT : Imf::FLOAT, samples.data() + begin,
                                Imath::V2i(window.x, window.y + y), window.width, rows);
      },
      channel.samples);
}

Metadata metadata_of(const Imf::Header& header) {
  Metadata metadata;
  for (auto i = header.begin(); i != header.end(); ++i) {
    const Imf::Attribute& value = i.attribute();
    if (is_reserved_exr_name(i.name())) continue;
    if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&value)) {
      metadata.push_back({i.name(), text->value()});
    } else if (const auto* wide = dynamic_cast<const Imf::DoubleAttribute*>(&value)) {
      metadata.push_back({i.name(), wide->value()});
    } else if (const auto* narrow = dynamic_cast<const Imf::FloatAttribute*>(&value)) {
      metadata.push_back({i.name(), double{narrow->value()}});
    } else if (const auto* integer = dynamic_cast<const Imf::IntAttribute*>(&value)) {
      metadata.push_back({i.name(), double{static_cast<double>(integer->value())}});
    }
  }
  return metadata;
}

LayeredImage read_whole_part(const Source& source, Imf::MultiPartInputFile& file, int index) {
  const Imf::Header& header = file.header(index);
  if (is_deep(header)) throw file_error(source.file, "holds deep data, which are not read");
  check_samplings(source, header);
  const Window window = window_of(source, header);
  LayeredImage image{window.width, window.height, {}, metadata_of(header)};
  const std::size_t pixels = static_cast<std::size_t>(window.width) * window.height;
  for (auto i = header.channels().begin(); i != header.channels().end(); ++i) {
    image.channels.push_back(empty_channel(i.name(), i.channel().type, pixels));
  }
  Imf::InputPart part(file, index);
  read_blocks(part, window, [&](int y, int rows) {
    Imf::FrameBuffer frame;
    for (Channel& channel : image.channels) {
      frame.insert(channel.name, grown_slice(channel, window, y, rows));
    }
    return frame;
  });
  return image;
}

/// `use(file)` of the opened file, with OpenEXR's exceptions as Error.
template <typename Use>
auto with_file(const Source& source, const Use& use) {
  try {
    check_headers(source);
    MemoryStream stream(source);
    Imf::MultiPartInputFile file(stream, 0);
    return use(file);
  } catch (const Iex::BaseExc& failure) {
    throw broken_file(source, FileFormat::exr, failure.what());
  }
}

}  // namespace

Image read_exr(const Source& source) {
  return with_file(source, [&](Imf::MultiPartInputFile& file) {
    const Place place = find_layer(source, file);
    const Imf::Header& header = file.header(place.part);
    check_samplings(source, header);
    return read_place(file, window_of(source, header), place, source.options.alpha);
  });
}

LayeredImage read_exr_layers(const Source& source) {
  return with_file(source,
                   [&](Imf::MultiPartInputFile& file) { return read_whole_part(source, file, 0); });
}

std::optional<LayeredImage> read_exr_part(const Source& source, const std::string& name) {
  return with_file(source, [&](Imf::MultiPartInputFile& file) -> std::optional<LayeredImage> {
    for (int i = 0; i < file.parts(); ++i) {
      const Imf::Header& header = file.header(i);
      if (header.hasName() && header.name() == name) return read_whole_part(source, file, i);
    }
    return std::nullopt;
  });
}

}  // namespace lapidary::image
