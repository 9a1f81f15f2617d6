#include "import/text_blocks.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <span>

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary::import {
namespace {

constexpr std::size_t block_size = std::size_t{1} << 20;
// What ends the last line, and one character behind the block.
constexpr std::string_view closing = "\n\n";
constexpr std::size_t padding = closing.size() + 1;

std::FILE* open(const std::filesystem::path& file, const InputFiles* files) {
  const auto content = file_content(files, file);
  if (!content) return std::fopen(file.c_str(), "rb");
  // Opened for reading, it is only read.
  return ::fmemopen(const_cast<char*>(content->data()), content->size(), "rb");
}

}  // namespace

TextBlocks TextBlocks::of_file(const std::filesystem::path& file, InputFiles* files) {
  TextBlocks blocks;
  blocks.name_ = file.string();
  blocks.file_.reset(open(file, files));
  if (!blocks.file_) {
    const bool is_missing = errno == ENOENT;
    throw file_error(blocks.name_,
                     is_missing ? "there is no such file"
                                : fmt::format("cannot be opened: {}", std::strerror(errno)),
                     is_missing ? "check the name and the folder" : "");
  }
  std::setvbuf(blocks.file_.get(), nullptr, _IONBF, 0);
  blocks.buffer_.resize(block_size + padding);
  blocks.files_ = files;
  return blocks;
}

TextBlocks TextBlocks::of_text(std::string_view text) {
  TextBlocks blocks;
  blocks.buffer_.assign(text.begin(), text.end());
  blocks.buffer_.insert(blocks.buffer_.end(), closing.begin(), closing.end());
  blocks.end_ = blocks.buffer_.size();
  blocks.buffer_.push_back('\0');
  return blocks;
}

std::string_view TextBlocks::next() {
  std::size_t block_end = file_ ? 0 : end_;
  while (file_) {
    fill();
    block_end = file_ ? end_of_lines() : end_;
    if (block_end > begin_ || !file_) break;
    if (end_ - begin_ > longest_line) {
      throw file_error(name_, fmt::format("has a line of more than {} MB", longest_line >> 20),
                       "is it a text file?");
    }
    buffer_.resize(2 * buffer_.size());
  }
  const std::string_view block(buffer_.data() + begin_, block_end - begin_);
  begin_ = block_end;
  return block;
}

// Moves what is left to the front and reads behind it; adds the closing at the end of the file.
void TextBlocks::fill() {
  std::copy(buffer_.begin() + static_cast<std::ptrdiff_t>(begin_),
            buffer_.begin() + static_cast<std::ptrdiff_t>(end_), buffer_.begin());
  end_ -= begin_;
  begin_ = 0;
  const std::size_t space = buffer_.size() - padding - end_;
  const std::size_t count = std::fread(buffer_.data() + end_, 1, space, file_.get());
  if (files_) hash_.add(std::as_bytes(std::span(buffer_).subspan(end_, count)));
  end_ += count;
  if (count == space) return;
  if (std::ferror(file_.get())) {
    throw file_error(name_, fmt::format("cannot be read: {}", std::strerror(errno)));
  }
  file_.reset();
  if (files_) files_->add(name_, hash_.finish());
  std::copy(closing.begin(), closing.end(), buffer_.begin() + static_cast<std::ptrdiff_t>(end_));
  end_ += closing.size();
  buffer_[end_] = '\0';
}

// Behind the last line end that is certain to be one and not continued; begin_ if there is none.
std::size_t TextBlocks::end_of_lines() const {
  for (std::size_t k = end_; k > begin_; --k) {
    const char c = buffer_[k - 1];
    if (c != '\n' && c != '\r') continue;
    if (c == '\r' && k == end_) continue;  // LF may follow
    std::size_t line_end = k - 1;
    if (c == '\n' && line_end > begin_ && buffer_[line_end - 1] == '\r') --line_end;
    if (line_end > begin_ && buffer_[line_end - 1] == '\\') continue;
    return k;
  }
  return begin_;
}

}  // namespace lapidary::import
