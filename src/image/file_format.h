#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

namespace lapidary::image {

/// The image file formats that are read and written.
enum class FileFormat { png, jpeg, radiance, exr };

/// "PNG", "JPEG", "Radiance", "OpenEXR".
std::string_view name_of(FileFormat format);

/// The format a file of this name is written in: .png, .jpg or .jpeg, .hdr, .exr in any case.
/// Throws Error with the known extensions for any other.
FileFormat format_of_name(const std::filesystem::path& path);

/// The format a file's first bytes say it is in, whatever its name.
std::optional<FileFormat> format_of_content(std::span<const std::byte> bytes);

}  // namespace lapidary::image
