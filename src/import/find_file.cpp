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

// What there is of files. An InputFiles, if there is one, answers for the file system.
struct Files {
  InputFiles* files;

  bool is_file(const fs::path& path) const {
    return is_file_answer_yes(files, "being a file", path, [&path] {
      std::error_code error;
      return fs::is_regular_file(path, error);
    });
  }
  bool exists(const fs::path& path) const {
    return is_file_answer_yes(files, "existence", path, [&path] {
      std::error_code error;
      return fs::exists(path, error);
    });
  }
  // The entry of `folder` that is `name` but for letter case; the first in the alphabet if several,
  // and empty if none.
  fs::path entry_in_any_case(const fs::path& folder, const std::string& name) const {
    return file_answer(files, "entry in any case", folder / name,
                       [&] { return find_entry(folder, name).string(); });
  }
  std::optional<fs::path> path_in_any_case(const fs::path& folder, const fs::path& relative) const {
    fs::path path = folder;
    for (const fs::path& part : relative) {
      if (part == "." || part == ".." || part.is_absolute() || exists(path / part)) {
        path /= part;
        continue;
      }
      const fs::path entry = entry_in_any_case(path, part.string());
      if (entry.empty()) return std::nullopt;
      path /= entry;
    }
    return path;
  }

 private:
  static fs::path find_entry(const fs::path& folder, const std::string& name) {
    std::error_code error;
    fs::path best;
    const fs::path listed = folder.empty() ? fs::path(".") : folder;
    for (fs::directory_iterator i(listed, error), end; !error && i != end; i.increment(error)) {
      const fs::path entry = i->path().filename();
      if (lower(entry.string()) == lower(name) && (best.empty() || entry < best)) best = entry;
    }
    return best;
  }
};

}  // namespace

fs::path resolve(const fs::path& folder, std::string stated) {
  std::replace(stated.begin(), stated.end(), '\\', '/');
  return (folder / stated).lexically_normal();
}

FoundFile find_file(const fs::path& folder, const std::string& stated, const AllowFile& allow,
                    InputFiles* files) {
  const Files on_disk{files};
  std::string slashed = stated;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  const fs::path relative(slashed);
  std::vector<fs::path> candidates{folder / stated, folder / relative};
  if (const auto path = on_disk.path_in_any_case(folder, relative)) candidates.push_back(*path);
  candidates.push_back(folder / relative.filename());
  if (const auto path = on_disk.path_in_any_case(folder, relative.filename()))
    candidates.push_back(*path);

  FoundFile result;
  for (const fs::path& candidate : candidates) {
    if (allow && !allow(candidate)) {
      if (on_disk.is_file(candidate)) result.status = FoundFile::Status::refused;
      continue;
    }
    if (on_disk.is_file(candidate)) return {FoundFile::Status::found, candidate.lexically_normal()};
  }
  return result;
}

}  // namespace lapidary::import
