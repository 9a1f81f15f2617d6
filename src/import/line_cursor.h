#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace lapidary::import {

/// Walks through blocks of lines (import/text_blocks.h), for formats of one statement a line whose
/// words are separated by blanks, comments start with '#', and a backslash before the line end
/// continues the line. Knows where it is.
class LineCursor {
 public:
  /// `file` is for messages.
  explicit LineCursor(std::string file) : file_(std::move(file)) {}

  void start_block(std::string_view block);
  bool block_done() const { return p_ >= end_; }

  /// Moves over blanks and continued line ends.
  void skip_blanks() {
    while (*p_ == ' ' || *p_ == '\t') ++p_;
    if (*p_ == '\\' || *p_ == '\v' || *p_ == '\f') skip_rare_blanks();
  }
  bool at_line_end() const { return *p_ == '\n' || *p_ == '\r'; }
  /// At the line end or a comment.
  bool at_end() const { return at_line_end() || *p_ == '#'; }
  /// Between words.
  bool at_boundary() const { return is_blank(*p_) || at_end() || *p_ == '\\'; }

  char peek() const { return *p_; }
  void advance() { ++p_; }

  /// The characters up to the next blank, line end or backslash.
  std::string_view word();
  /// The rest of the statement without blanks around it; continued lines are joined by a space.
  std::string rest();
  /// Moves to the next line: behind this statement and all its continuations, or behind a comment,
  /// which is never continued.
  void next_statement();

  /// A finite number that a float can hold; throws Error when there is none, naming it `what`.
  double number(const char* what);
  /// False, without moving, when there is no integer.
  bool integer(std::int64_t& value);

  int line() const { return line_; }
  Location here() const;
  [[noreturn]] void fail(std::string problem, std::string hint = "") const;
  /// The word at the cursor as it can be shown in a message.
  std::string quoted_word() const;

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  bool continues() const;
  void skip_rare_blanks();
  void skip_line_end();

  std::string file_;
  const char* p_ = nullptr;
  const char* end_ = nullptr;
  const char* line_begin_ = nullptr;
  int line_ = 1;
};

}  // namespace lapidary::import
