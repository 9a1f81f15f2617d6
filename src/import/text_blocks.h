#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/input_files.h"

namespace lapidary::import {

/// A text as a sequence of blocks of whole lines, so that a file of any size takes little memory.
///
/// Lines end in LF, CR LF or CR. No block ends in a line that a backslash continues, and the last
/// one ends in an empty line whatever the text ends in, so that a parser needs to look for line
/// ends alone. One character after each block may be read.
class TextBlocks {
 public:
  /// Once `file` has been read to its end, `files` is told; it may be null. Throws Error when it
  /// cannot be opened.
  static TextBlocks of_file(const std::filesystem::path& file, InputFiles* files = nullptr);
  static TextBlocks of_text(std::string_view text);

  /// The next block, valid until the next call; empty at the end. Throws Error when the file
  /// cannot be read, or has a line of more than `longest_line` bytes.
  std::string_view next();

  static constexpr std::size_t longest_line = std::size_t{64} << 20;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  TextBlocks() = default;
  void fill();
  std::size_t end_of_lines() const;

  std::string name_;
  std::unique_ptr<std::FILE, Close> file_;  // null at the end
  InputFiles* files_ = nullptr;
  Sha256 hash_;  // of the file so far, if `files_` is to know
  std::vector<char> buffer_;
  std::size_t begin_ = 0;  // of what was not handed out yet
  std::size_t end_ = 0;    // of what was read
};

}  // namespace lapidary::import
