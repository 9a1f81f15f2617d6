#pragma once

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/sha256.h"

namespace lapidary {

/// A file that something was made from.
struct FileRecord {
  std::string name;
  std::string sha256;  ///< of its bytes, 64 hexadecimal digits

  auto operator<=>(const FileRecord&) const = default;
};

/// Notes the files that a scene is made from. Whoever reads one says so here, with what was read of
/// it: that is then what counts, whatever becomes of the file.
class InputFiles {
 public:
  /// From any thread.
  void add(const std::filesystem::path& file, const Sha256::Digest& digest);
  /// The same of all its bytes.
  void add(const std::filesystem::path& file, std::span<const std::byte> content);

  /// What others have noted.
  void add(const InputFiles& others);

  /// Sorted, each once, with names relative to `folder`: the same wherever a folder with all of
  /// them is. A file that changed between two readings is there twice.
  std::vector<FileRecord> relative_to(const std::filesystem::path& folder) const;

 private:
  mutable std::mutex mutex_;
  std::set<std::pair<std::filesystem::path, std::string>> files_;
};

}  // namespace lapidary
