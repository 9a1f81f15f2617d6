#pragma once

#include <span>
#include <string>
#include <vector>

namespace lapidary::app {

/// A file that a command is to write or to read.
struct NamedFile {
  std::string file;
  std::string role;  ///< what it is there, for messages: "--stats", "the scene"
};

/// Finds out before the work whether one of its results would take another's place, or that of a
/// file that is read, by whatever path: throws UsageError.
void check_distinct(std::span<const NamedFile> written, std::span<const NamedFile> read);

}  // namespace lapidary::app
