#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/input_files.h"
#include "description/settings.h"

namespace lapidary::render {

using NamedTexts = std::vector<std::pair<std::string, std::string>>;

/// What a picture was made from: everything that determines its bits but the number of samples.
struct Origin {
  std::string version;  ///< Lapidary's
  std::string scene;    ///< the name of its file; shown, and free to change
  /// All keys of the scene's tables `render` and `film` (description::setting_texts). Those that
  /// say when to stop, and the tone of 8-bit pictures, are there to be shown and may change.
  NamedTexts settings;
  NamedTexts parameters;          ///< what else the command line gave the scene
  std::vector<FileRecord> files;  ///< sorted by name

  bool operator==(const Origin&) const = default;
};

/// The settings as values again. Throws Error for texts that are none.
std::pair<description::RenderSettings, description::FilmSettings> settings_of(const Origin& origin);

/// What makes pictures of `now` others than those of `then`, a line each; empty where they are the
/// same for the same number of samples.
std::vector<std::string> differences(const Origin& then, const Origin& now);

/// Lines "name = text", and what they mean; line breaks and backslashes are escaped.
std::string to_lines(const NamedTexts& texts);
NamedTexts parse_lines(std::string_view lines);

/// Lines "digest  name", as `sha256sum --check` takes them, and what they mean.
std::string to_lines(std::span<const FileRecord> files);
std::vector<FileRecord> parse_file_lines(std::string_view lines);

}  // namespace lapidary::render
