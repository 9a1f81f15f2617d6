#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace lapidary::image {

/// A file that appears under its name complete or not at all.
///
/// The bytes go to a temporary file in the same folder, without a name where the file system has
/// such files, so that nothing is left of it whatever ends the process; `commit` gives it the name,
/// in one step that replaces a file already there. Without `commit` the temporary file is removed
/// and whatever had the name is untouched. A symbolic link is followed, not replaced.
/// Every failure throws Error with the path and the reason.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }

  void write(const void* data, std::size_t size);
  std::uint64_t position() const;
  void seek(std::uint64_t position);

  /// The bytes are on the disk and the file has its name when this returns.
  void commit();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  /// One for the moment, in the target's folder.
  void give_name();
  [[noreturn]] void fail(int error_number) const;

  std::filesystem::path path_;       ///< as the user gave it
  std::filesystem::path target_;     ///< what it stands for, links followed
  std::filesystem::path temporary_;  ///< empty when there is none to remove
  std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace lapidary::image
