#include "base/input_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary {
namespace {

namespace fs = std::filesystem;

/// Absolute, with links followed as far as there is anything.
fs::path find_real_path(const fs::path& path) {
  std::error_code problem;
  const fs::path absolute = fs::absolute(path.empty() ? "." : path, problem);
  const fs::path real = fs::weakly_canonical(absolute, problem);
  return problem ? absolute.lexically_normal() : real;
}

constexpr std::string_view content_question = "content";

/// No path has a zero byte in it.
std::string key_of(std::string_view question, const fs::path& path) {
  return std::string(question) + '\0' + path.string();
}

std::string read_whole(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  if (!stream) throw file_error(file.string(), "cannot be read again");
  return bytes;
}

}  // namespace

fs::path InputFiles::real_path(const fs::path& path) {
  return answer("real path", path, [&path] { return find_real_path(path).string(); });
}

std::string InputFiles::answer(std::string_view question, const fs::path& path,
                               const std::function<std::string()>& ask) {
  const std::lock_guard lock(mutex_);
  const std::string key = key_of(question, path);
  const auto known = answers_.find(key);
  if (known != answers_.end()) return known->second;
  if (is_copy_) {
    throw file_error(path.string(), fmt::format("its {} was not sent", question),
                     "this is a fault of the renderer; --shared-files does without");
  }
  return answers_.emplace(key, ask()).first->second;
}

std::optional<std::string_view> InputFiles::content(const fs::path& file) const {
  if (!is_copy_) return std::nullopt;
  const std::lock_guard lock(mutex_);
  const auto known = answers_.find(key_of(content_question, file));
  // Where the other one could not read it either, this is what its reader was told.
  if (known == answers_.end()) throw file_error(file.string(), "cannot be read");
  return known->second;
}

FileAnswers InputFiles::answers() const {
  const std::lock_guard lock(mutex_);
  FileAnswers all = answers_;
  for (const fs::path& file : read_) all.emplace(key_of(content_question, file), read_whole(file));
  return all;
}

void InputFiles::forget_contents() {
  const std::lock_guard lock(mutex_);
  std::erase_if(answers_, [](const auto& known) {
    return known.first.starts_with(key_of(content_question, {}));
  });
}

void InputFiles::add(const fs::path& file, const Sha256::Digest& digest) {
  fs::path real = real_path(file);
  const std::lock_guard lock(mutex_);
  journal_.push_back({file, std::move(real), to_text(digest)});
  files_.insert({journal_.back().real, journal_.back().digest});
  read_.insert(file);
}

void InputFiles::add(const fs::path& file, std::span<const std::byte> content) {
  Sha256 hash;
  hash.add(content);
  add(file, hash.finish());
}

std::size_t InputFiles::noted() const {
  const std::lock_guard lock(mutex_);
  return journal_.size();
}

std::vector<InputFiles::Note> InputFiles::noted_since(std::size_t first) const {
  const std::lock_guard lock(mutex_);
  return {journal_.begin() + static_cast<std::ptrdiff_t>(first), journal_.end()};
}

void InputFiles::note_again(std::span<const Note> notes) {
  const std::lock_guard lock(mutex_);
  for (const Note& note : notes) {
    files_.insert({note.real, note.digest});
    read_.insert(note.file);
  }
  journal_.insert(journal_.end(), notes.begin(), notes.end());
}

std::vector<FileRecord> InputFiles::relative_to(const fs::path& folder) {
  const fs::path real = real_path(folder);
  const std::lock_guard lock(mutex_);
  std::vector<FileRecord> all;
  for (const auto& [file, digest] : files_) {
    all.push_back({file.lexically_relative(real).string(), digest});
  }
  std::sort(all.begin(), all.end());
  return all;
}

std::string file_answer(InputFiles* files, std::string_view question, const fs::path& path,
                        const std::function<std::string()>& ask) {
  return files != nullptr ? files->answer(question, path, ask) : ask();
}

bool is_file_answer_yes(InputFiles* files, std::string_view question, const fs::path& path,
                        const std::function<bool()>& ask) {
  return file_answer(files, question, path, [&ask] { return ask() ? "yes" : "no"; }) == "yes";
}

std::optional<std::string_view> file_content(const InputFiles* files, const fs::path& file) {
  return files != nullptr ? files->content(file) : std::nullopt;
}

}  // namespace lapidary
