#include <cerrno>
#include <cstring>
#include <new>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "image/codecs.h"

namespace lapidary::image {
namespace {

/// An open file, closed at the end of the scope.
struct Descriptor {
  int number;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

std::vector<std::byte> file_bytes(const std::string& file) {
  // O_NONBLOCK: opening a pipe that nobody writes to would wait for ever.
  const Descriptor descriptor{::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  struct stat status {};
  if (descriptor.number < 0 || ::fstat(descriptor.number, &status) != 0) {
    throw file_error(file, fmt::format("cannot be opened: {}", std::strerror(errno)));
  }
  if (S_ISDIR(status.st_mode)) throw file_error(file, "is a folder, not a picture");
  if (!S_ISREG(status.st_mode)) throw file_error(file, "is not a regular file");
  std::vector<std::byte> bytes(static_cast<std::size_t>(status.st_size));
  std::size_t have = 0;
  while (have < bytes.size()) {
    const ssize_t got = ::read(descriptor.number, bytes.data() + have, bytes.size() - have);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw file_error(file, fmt::format("cannot be read: {}", std::strerror(errno)));
    if (got == 0) break;
    have += static_cast<std::size_t>(got);
  }
  bytes.resize(have);
  if (bytes.empty()) throw file_error(file, "is empty");
  return bytes;
}

FileFormat content_format(const Source& source) {
  const auto format = format_of_content(source.bytes);
  if (format) return *format;
  throw file_error(source.file, "is not a picture in a known format",
                   "PNG, JPEG, Radiance (.hdr) and OpenEXR can be read");
}

void check_has_parts(const Source& source, FileFormat format) {
  if (format == FileFormat::exr) return;
  throw file_error(source.file, fmt::format("is a {} file, which has no layers", name_of(format)),
                   "an OpenEXR file is needed");
}

/// `decode(source, format)` of the file's content, with memory that runs out as an Error.
template <typename Decode>
auto decode_file(const std::filesystem::path& path, const ReadOptions& options,
                 const Decode& decode) {
  const std::string file = path.string();
  try {
    const auto content = file_content(options.files, path);
    const std::vector<std::byte> read = content ? std::vector<std::byte>() : file_bytes(file);
    const auto bytes = content ? std::as_bytes(std::span(*content)) : std::span(read);
    if (options.files) options.files->add(path, bytes);
    const Source source{file, bytes, options};
    return decode(source, content_format(source));
  } catch (const std::bad_alloc&) {
    throw file_error(file, "does not fit in memory");
  }
}

}  // namespace

Image read_image(const std::filesystem::path& path, const ReadOptions& options) {
  return decode_file(path, options, [](const Source& source, FileFormat format) {
    switch (format) {
      case FileFormat::png:
        return read_png(source);
      case FileFormat::jpeg:
        return read_jpeg(source);
      case FileFormat::radiance:
        return read_radiance(source);
      case FileFormat::exr:
        break;
    }
    return read_exr(source);
  });
}

LayeredImage read_layers(const std::filesystem::path& path) {
  return decode_file(path, {}, [](const Source& source, FileFormat format) {
    check_has_parts(source, format);
    return read_exr_layers(source);
  });
}

std::optional<LayeredImage> read_part(const std::filesystem::path& path, const std::string& name) {
  return decode_file(path, {}, [&name](const Source& source, FileFormat format) {
    check_has_parts(source, format);
    return read_exr_part(source, name);
  });
}

}  // namespace lapidary::image
