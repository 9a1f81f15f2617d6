#include "lua/folder_guard.h"

#include <algorithm>

#include <fmt/format.h>

#include "schema/suggest.h"

namespace lapidary::lua {
namespace {

namespace fs = std::filesystem;

/// Absolute, with links and ".." followed; empty when it cannot be known.
fs::path find_real_path(const fs::path& path) {
  std::error_code problem;
  const fs::path absolute = fs::absolute(path.empty() ? "." : path, problem);
  if (problem) return {};
  const fs::path found = fs::weakly_canonical(absolute, problem);
  if (problem) return {};
  // "folder/" and "folder" are the same place.
  return found.has_filename() ? found : found.parent_path();
}

bool within(const fs::path& path, const fs::path& root) {
  if (path.empty() || root.empty()) return false;
  const auto [root_end, path_at] =
      std::mismatch(root.begin(), root.end(), path.begin(), path.end());
  return root_end == root.end();
}

}  // namespace

std::string similar_file(const fs::path& missing) {
  constexpr std::size_t most = 1000;  // a suggestion is not worth reading a huge folder
  std::vector<std::string> names;
  std::error_code problem;
  const fs::path folder = missing.has_parent_path() ? missing.parent_path() : fs::path(".");
  for (fs::directory_iterator it(folder, problem), end;
       !problem && it != end && names.size() < most; it.increment(problem)) {
    names.push_back(it->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  const std::vector<std::string_view> views(names.begin(), names.end());
  return schema::did_you_mean(missing.filename().string(), views);
}

FolderGuard::FolderGuard(const fs::path& scene_folder, const std::vector<fs::path>& allowed,
                         InputFiles* files)
    : files_(files), scene_folder_(scene_folder) {
  roots_.push_back(real_path(scene_folder));
  for (const fs::path& path : allowed) roots_.push_back(real_path(path));
}

fs::path FolderGuard::real_path(const fs::path& path) const {
  return file_answer(files_, "real place", path, [&path] { return find_real_path(path).string(); });
}

bool FolderGuard::allows(const fs::path& file) const {
  const fs::path real = real_path(file);
  return std::any_of(roots_.begin(), roots_.end(),
                     [&real](const fs::path& root) { return within(real, root); });
}

std::string FolderGuard::shown(const fs::path& file) const {
  if (!within(file, roots_.front())) return file.string();
  return (scene_folder_ / file.lexically_relative(roots_.front())).string();
}

fs::path FolderGuard::resolve(std::string_view written, const schema::Context& context) const {
  if (written.find('\0') != std::string_view::npos) context.fail("is no file name");
  std::error_code problem;
  for (const fs::path& root : roots_) {
    const fs::path path = root / fs::path(written);
    // Nothing is said about what exists where a scene must not look.
    if (!allows(path)) continue;
    const bool is_file = is_file_answer_yes(files_, "being a file", path,
                                            [&] { return fs::is_regular_file(path, problem); });
    if (is_file) return real_path(path);
  }
  const fs::path path = roots_.front() / fs::path(written);
  if (!allows(path)) {
    context.fail(fmt::format("names a file outside the scene's folder: '{}'", written),
                 "--allow DIR lets scenes read there");
  }
  if (fs::exists(path, problem)) context.fail(fmt::format("names no file: '{}'", written));
  context.fail(fmt::format("names a file that does not exist: '{}'", written), similar_file(path));
}

}  // namespace lapidary::lua
