#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
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

/// Questions to a file system, and their answers; the contents of files are among them.
using FileAnswers = std::map<std::string, std::string>;

/// Notes the files that a scene is made from. Whoever reads one says so here, with what was read of
/// it: that is then what counts, whatever becomes of the file.
///
/// With the answers of another one it stands for the file system which that has asked, on whatever
/// machine: what is asked here must have been asked there.
class InputFiles {
 public:
  InputFiles() = default;
  explicit InputFiles(FileAnswers answers) : answers_(std::move(answers)), is_copy_(true) {}

  /// What `ask` answers to a question about a path; it is asked once. Throws Error where it was to
  /// be known already and is not.
  std::string answer(std::string_view question, const std::filesystem::path& path,
                     const std::function<std::string()>& ask);
  /// The bytes of a file, valid until `forget_contents`, if it is not the file system that has
  /// them. Throws Error where they were to be known already and are not.
  std::optional<std::string_view> content(const std::filesystem::path& file) const;

  /// All answers so far, and the contents of the files that were read, which are read again. Throws
  /// Error for one that cannot be.
  FileAnswers answers() const;
  void forget_contents();

  /// From any thread.
  void add(const std::filesystem::path& file, const Sha256::Digest& digest);
  /// The same of all its bytes.
  void add(const std::filesystem::path& file, std::span<const std::byte> content);

  /// One call of `add`, for what is kept of a file: whoever uses it again notes it again.
  struct Note {
    std::filesystem::path file;  ///< as its reader called it
    std::filesystem::path real;
    std::string digest;
  };
  std::size_t noted() const;  ///< how many notes there are
  std::vector<Note> noted_since(std::size_t first) const;
  void note_again(std::span<const Note> notes);

  /// Sorted, each once, with names relative to `folder`: the same wherever a folder with all of
  /// them is. A file that changed between two readings is there twice.
  std::vector<FileRecord> relative_to(const std::filesystem::path& folder);

 private:
  std::filesystem::path real_path(const std::filesystem::path& path);

  mutable std::mutex mutex_;
  std::set<std::pair<std::filesystem::path, std::string>> files_;
  std::set<std::filesystem::path> read_;  ///< as their readers called them
  std::vector<Note> journal_;
  FileAnswers answers_;
  bool is_copy_ = false;
};

/// The answers of `files`, or if that is null those of the file system itself.
std::string file_answer(InputFiles* files, std::string_view question,
                        const std::filesystem::path& path, const std::function<std::string()>& ask);
/// Of a question with yes or no.
bool is_file_answer_yes(InputFiles* files, std::string_view question,
                        const std::filesystem::path& path, const std::function<bool()>& ask);
/// InputFiles::content, or nothing if `files` is null.
std::optional<std::string_view> file_content(const InputFiles* files,
                                             const std::filesystem::path& file);

}  // namespace lapidary
