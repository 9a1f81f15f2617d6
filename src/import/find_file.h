#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/input_files.h"

namespace lapidary::import {

/// Whether a file may be read; empty: any may.
using AllowFile = std::function<bool(const std::filesystem::path&)>;

struct FoundFile {
  enum class Status { found, missing, refused };
  Status status = Status::missing;
  std::filesystem::path path;
};

/// The file that a text calls `stated`, from a file in `folder`: as stated; with '\' for '/'; with
/// other letter case; at last by its name alone, in `folder`, as paths from another computer need
/// it. Only regular files count, and only those that `allow` lets through are found. `files`, if
/// not null, answers for the file system.
FoundFile find_file(const std::filesystem::path& folder, const std::string& stated,
                    const AllowFile& allow, InputFiles* files = nullptr);

/// `stated` relative to `folder`, with '/' for '\'.
std::filesystem::path resolve(const std::filesystem::path& folder, std::string stated);

}  // namespace lapidary::import
