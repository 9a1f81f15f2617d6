#include "app/named_files.h"

#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "app/command_line.h"

namespace lapidary::app {
namespace {

namespace fs = std::filesystem;

/// Whether two paths lead to one file, be it there or not.
bool are_one(const std::string& a, const std::string& b) {
  std::error_code ignored;
  if (fs::equivalent(a, b, ignored)) return true;
  const auto real = [](const std::string& path) {
    std::error_code problem;
    const fs::path absolute = fs::absolute(path, problem);
    const fs::path found = fs::weakly_canonical(absolute, problem);
    return problem ? absolute.lexically_normal() : found;
  };
  return real(a) == real(b);
}

}  // namespace

void check_distinct(std::span<const NamedFile> written, std::span<const NamedFile> read) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    const auto& [file, role] = written[i];
    for (const NamedFile& other : written.first(i)) {
      if (!are_one(file, other.file)) continue;
      throw UsageError(
          fmt::format("{} {} and {} {} are one file", other.role, other.file, role, file),
          "one would replace the other; give another name");
    }
    for (const NamedFile& other : read) {
      if (!are_one(file, other.file)) continue;
      throw UsageError(fmt::format("{} {} would replace {}", role, file, other.role),
                       "give another name");
    }
  }
}

}  // namespace lapidary::app
