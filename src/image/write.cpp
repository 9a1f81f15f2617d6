#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "image/codecs.h"

namespace lapidary::image {
namespace {

/// What every format can carry: PNG is the strictest with names, C strings with values.
void check_metadata(const std::string& file, const Metadata& metadata) {
  std::set<std::string_view> names;
  for (const Attribute& attribute : metadata) {
    const std::string& name = attribute.name;
    const bool plain =
        std::all_of(name.begin(), name.end(), [](char c) { return c > 32 && c < 127; });
    if (name.empty() || name.size() > 79 || !plain) {
      throw file_error(file, fmt::format("the metadata name '{}' cannot be written", name),
                       "a name is 1 to 79 ASCII characters without spaces");
    }
    if (!names.insert(name).second) {
      throw file_error(file, fmt::format("the metadata name '{}' is given twice", name));
    }
    const auto* text = std::get_if<std::string>(&attribute.value);
    if (text && text->find('\0') != std::string::npos) {
      throw file_error(file, fmt::format("the text of the metadata '{}' has a null byte", name));
    }
  }
}

std::size_t sample_count(const Channel& channel) {
  return std::visit([](const auto& samples) { return samples.size(); }, channel.samples);
}

void check_size(const std::string& file, int width, int height) {
  if (width < 1 || height < 1) {
    throw file_error(file,
                     fmt::format("a picture of {} x {} pixels cannot be written", width, height));
  }
}

void check_channel_name(const std::string& file, const std::string& name,
                        std::set<std::string_view>& names) {
  if (!name.empty() && name.size() <= 255 && names.insert(name).second) return;
  throw file_error(file, fmt::format("the channel name '{}' cannot be written", name),
                   "names are 1 to 255 characters and each is used once");
}

void check_image(const std::string& file, const Image& image) {
  check_size(file, image.width, image.height);
  if (image.channels != 1 && image.channels != 3 && image.channels != 4) {
    throw file_error(file,
                     fmt::format("a picture of {} channels cannot be written", image.channels),
                     "1, 3 or 4 channels can");
  }
  if (image.pixels.size() !=
      static_cast<std::size_t>(image.width) * image.height * image.channels) {
    throw file_error(file, "the picture to write has not as many pixels as its size says");
  }
}

void check_image(const std::string& file, const LayeredImage& image) {
  check_size(file, image.width, image.height);
  if (image.channels.empty())
    throw file_error(file, "a picture without channels cannot be written");
  const std::size_t pixels = static_cast<std::size_t>(image.width) * image.height;
  std::set<std::string_view> names;
  for (const Channel& channel : image.channels) {
    check_channel_name(file, channel.name, names);
    if (sample_count(channel) != pixels) {
      throw file_error(file, fmt::format("channel {} has {} samples, the picture has {} pixels",
                                         channel.name, sample_count(channel), pixels));
    }
  }
}

void check_attachment(const std::string& file, const Attachment& attachment) {
  check_size(file, attachment.width, attachment.height);
  std::set<std::string_view> names;
  for (const auto& channel : attachment.channels) check_channel_name(file, channel.name, names);
  check_metadata(file, attachment.metadata);
}

RowSource rows_of(const Image& image) {
  const std::size_t step = static_cast<std::size_t>(image.channels);
  return {image.width, image.height, [&image, step](int y, std::span<float> rgb) {
            const auto row = image.row(y);
            for (std::size_t x = 0; x < static_cast<std::size_t>(image.width); ++x) {
              for (std::size_t c = 0; c < 3; ++c)
                rgb[3 * x + c] = row[x * step + (step < 3 ? 0 : c)];
            }
          }};
}

RowSource rows_of(const std::string& file, const LayeredImage& image) {
  const std::vector<float>* planes[3];
  constexpr std::string_view names[3] = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    const Channel* channel = image.find(names[c]);
    planes[c] = channel ? std::get_if<std::vector<float>>(&channel->samples) : nullptr;
    if (!planes[c]) {
      throw file_error(file, fmt::format("there is no float channel {} to write", names[c]));
    }
  }
  const auto width = static_cast<std::size_t>(image.width);
  return {image.width, image.height,
          [r = planes[0], g = planes[1], b = planes[2], width](int y, std::span<float> rgb) {
            const std::size_t first = static_cast<std::size_t>(y) * width;
            for (std::size_t x = 0; x < width; ++x) {
              rgb[3 * x] = (*r)[first + x];
              rgb[3 * x + 1] = (*g)[first + x];
              rgb[3 * x + 2] = (*b)[first + x];
            }
          }};
}

void write_rows(OutputFile& out, FileFormat format, const RowSource& rows,
                const WriteOptions& options) {
  if (format == FileFormat::png) write_png(out, rows, options);
  if (format == FileFormat::jpeg) write_jpeg(out, rows, options);
  if (format == FileFormat::radiance) write_radiance(out, rows, options);
}

}  // namespace

void write_image(const std::filesystem::path& path, const Image& image,
                 const WriteOptions& options) {
  const FileFormat format = format_of_name(path);
  check_image(path.string(), image);
  check_metadata(path.string(), options.metadata);
  OutputFile out(path);
  if (format == FileFormat::exr) {
    write_exr(out, image, options);
  } else {
    write_rows(out, format, rows_of(image), options);
  }
  out.commit();
}

void write_image(const std::filesystem::path& path, const LayeredImage& image,
                 const WriteOptions& options) {
  const FileFormat format = format_of_name(path);
  check_image(path.string(), image);
  WriteOptions merged = options;
  merged.metadata.insert(merged.metadata.begin(), image.metadata.begin(), image.metadata.end());
  check_metadata(path.string(), merged.metadata);
  OutputFile out(path);
  if (format == FileFormat::exr) {
    write_exr(out, image, merged);
  } else {
    write_rows(out, format, rows_of(path.string(), image), merged);
  }
  out.commit();
}

void write_image(const std::filesystem::path& path, const LayeredImage& image,
                 const Attachment& attachment, const WriteOptions& options) {
  if (format_of_name(path) != FileFormat::exr) {
    throw file_error(path.string(), "is of a format that has no room for a second part",
                     "OpenEXR (.exr) has");
  }
  check_image(path.string(), image);
  check_attachment(path.string(), attachment);
  WriteOptions merged = options;
  merged.metadata.insert(merged.metadata.begin(), image.metadata.begin(), image.metadata.end());
  check_metadata(path.string(), merged.metadata);
  OutputFile out(path);
  write_exr(out, image, attachment, merged);
  out.commit();
}

void check_writable(const std::filesystem::path& path) {
  format_of_name(path);
  const OutputFile never_committed(path);
}

}  // namespace lapidary::image
