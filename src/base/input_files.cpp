#include "base/input_files.h"

#include <algorithm>

namespace lapidary {
namespace {

namespace fs = std::filesystem;

/// Absolute, with links followed as far as there is anything.
fs::path real_path(const fs::path& path) {
  std::error_code problem;
  const fs::path absolute = fs::absolute(path.empty() ? "." : path, problem);
  const fs::path real = fs::weakly_canonical(absolute, problem);
  return problem ? absolute.lexically_normal() : real;
}

}  // namespace

void InputFiles::add(const fs::path& file, const Sha256::Digest& digest) {
  const std::lock_guard lock(mutex_);
  files_.insert({real_path(file), to_text(digest)});
}

void InputFiles::add(const fs::path& file, std::span<const std::byte> content) {
  Sha256 hash;
  hash.add(content);
  add(file, hash.finish());
}

void InputFiles::add(const InputFiles& others) {
  const std::scoped_lock lock(mutex_, others.mutex_);
  files_.insert(others.files_.begin(), others.files_.end());
}

std::vector<FileRecord> InputFiles::relative_to(const fs::path& folder) const {
  const fs::path real = real_path(folder);
  const std::lock_guard lock(mutex_);
  std::vector<FileRecord> all;
  for (const auto& [file, digest] : files_) {
    all.push_back({file.lexically_relative(real).string(), digest});
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace lapidary
