#include "import/find_file.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <vector>

namespace lapidary::import {
namespace {

namespace fs = std::filesystem;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// The entry of `folder` that is `name` but for letter case; the first in the alphabet if several.
std::optional<fs::path> entry_in_any_case(const fs::path& folder, const std::string& name) {
  std::error_code error;
  std::optional<fs::path> best;
  const fs::path listed = folder.empty() ? fs::path(".") : folder;
  for (fs::directory_iterator i(listed, error), end; !error && i != end; i.increment(error)) {
    const fs::path entry = i->path().filename();
    if (lower(entry.string()) == lower(name) && (!best || entry < *best)) best = entry;
  }
  if (!best) return std::nullopt;
  return folder / *best;
}

std::optional<fs::path> path_in_any_case(const fs::path& folder, const fs::path& relative) {
  fs::path path = folder;
  for (const fs::path& part : relative) {
    std::error_code error;
    if (part == "." || part == ".." || part.is_absolute() || fs::exists(path / part, error)) {
      path /= part;
      continue;
    }
    const std::optional<fs::path> entry = entry_in_any_case(path, part.string());
    if (!entry) return std::nullopt;
    path = *entry;
  }
  return path;
}

}  // namespace

fs::path resolve(const fs::path& folder, std::string stated) {
  std::replace(stated.begin(), stated.end(), '\\', '/');
  return (folder / stated).lexically_normal();
}

FoundFile find_file(const fs::path& folder, const std::string& stated, const AllowFile& allow) {
  std::string slashed = stated;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  const fs::path relative(slashed);
  std::vector<fs::path> candidates{folder / stated, folder / relative};
  if (const auto path = path_in_any_case(folder, relative)) candidates.push_back(*path);
  candidates.push_back(folder / relative.filename());
  if (const auto path = path_in_any_case(folder, relative.filename())) candidates.push_back(*path);

  FoundFile result;
  for (const fs::path& candidate : candidates) {
    if (allow && !allow(candidate)) {
      if (is_file(candidate)) result.status = FoundFile::Status::refused;
      continue;
    }
    if (is_file(candidate)) return {FoundFile::Status::found, candidate.lexically_normal()};
  }
  return result;
}

}  // namespace lapidary::import
