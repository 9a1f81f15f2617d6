#include "image/file_format.h"

#include <algorithm>
#include <cctype>
#include <string>

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary::image {
namespace {

using namespace std::string_view_literals;

struct Extension {
  std::string_view text;
  FileFormat format;
};
constexpr Extension extensions[] = {{".png", FileFormat::png},
                                    {".jpg", FileFormat::jpeg},
                                    {".jpeg", FileFormat::jpeg},
                                    {".hdr", FileFormat::radiance},
                                    {".exr", FileFormat::exr}};

constexpr std::string_view known_extensions =
    "known are .png, .jpg and .jpeg, .hdr (Radiance), .exr (OpenEXR)";

}  // namespace

std::string_view name_of(FileFormat format) {
  switch (format) {
    case FileFormat::png:
      return "PNG";
    case FileFormat::jpeg:
      return "JPEG";
    case FileFormat::radiance:
      return "Radiance";
    case FileFormat::exr:
      return "OpenEXR";
  }
  return "";
}

FileFormat format_of_name(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Extension& known : extensions) {
    if (known.text == extension) return known.format;
  }
  throw file_error(path.string(),
                   extension.empty()
                       ? "the name has no extension that says which image format to write"
                       : fmt::format("unknown image format '{}'", path.extension().string()),
                   std::string(known_extensions));
}

std::optional<FileFormat> format_of_content(std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (text.starts_with("\x89PNG\r\n\x1a\n"sv)) return FileFormat::png;
  if (text.starts_with("\xff\xd8\xff"sv)) return FileFormat::jpeg;
  if (text.starts_with("#?"sv)) return FileFormat::radiance;
  if (text.starts_with("\x76\x2f\x31\x01"sv)) return FileFormat::exr;
  return std::nullopt;
}

}  // namespace lapidary::image
