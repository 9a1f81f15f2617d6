#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_files.h"
#include "schema/context.h"

namespace lapidary::lua {

/// "did you mean 'duck.obj'?", from the files beside `missing`; empty when none has such a name.
std::string similar_file(const std::filesystem::path& missing);

/// Lets a scene reach the files under its own folder, under folders it was allowed, and files it
/// was given, and no others: symbolic links and ".." are followed first.
class FolderGuard : public schema::FileAccess {
 public:
  /// `allowed` are folders or files. `files`, if not null, answers for the file system.
  FolderGuard(const std::filesystem::path& scene_folder,
              const std::vector<std::filesystem::path>& allowed, InputFiles* files = nullptr);

  /// The regular file that a scene calls `written`: relative to the scene's folder, else to an
  /// allowed folder.
  std::filesystem::path resolve(std::string_view written,
                                const schema::Context& context) const override;

  /// Whether `file` may be read.
  bool allows(const std::filesystem::path& file) const;

  /// `file`, which `resolve` gave, as users know it: the way the scene's own path was written.
  std::string shown(const std::filesystem::path& file) const;

 private:
  std::filesystem::path real_path(const std::filesystem::path& path) const;

  InputFiles* files_;
  std::filesystem::path scene_folder_;        ///< as written
  std::vector<std::filesystem::path> roots_;  ///< canonical; the scene's folder first
};

}  // namespace lapidary::lua
