#include "import/line_cursor.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "import/numbers.h"

namespace lapidary::import {

void LineCursor::start_block(std::string_view block) {
  p_ = line_begin_ = block.data();
  end_ = block.data() + block.size();
}

// At a backslash that joins the next line to this one.
bool LineCursor::continues() const {
  return *p_ == '\\' && (p_[1] == '\n' || p_[1] == '\r');
}

void LineCursor::skip_rare_blanks() {
  for (;;) {
    if (is_blank(*p_)) {
      ++p_;
    } else if (continues()) {
      ++p_;
      skip_line_end();
    } else {
      return;
    }
  }
}

void LineCursor::skip_line_end() {
  p_ += p_[0] == '\r' && p_[1] == '\n' ? 2 : 1;
  line_begin_ = p_;
  ++line_;
}

std::string_view LineCursor::word() {
  const char* const begin = p_;
  while (!is_blank(*p_) && !at_line_end() && !continues()) ++p_;
  return {begin, static_cast<std::size_t>(p_ - begin)};
}

std::string LineCursor::rest() {
  skip_blanks();
  std::string text;
  while (!at_line_end()) {
    if (continues()) {
      skip_rare_blanks();
      text += ' ';
    } else {
      text += *p_++;
    }
  }
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  return text;
}

void LineCursor::next_statement() {
  bool comment = false;
  for (; !at_line_end(); ++p_) {
    comment = comment || *p_ == '#';
    if (!comment && continues()) {
      ++p_;
      skip_line_end();
      --p_;
    }
  }
  skip_line_end();
}

double LineCursor::number(const char* what) {
  skip_blanks();
  if (at_end()) fail(fmt::format("{} is missing", what));
  const char* const begin = p_;
  double value = 0;
  const NumberStatus status = parse_number(p_, value);
  const bool complete = status == NumberStatus::ok && at_boundary();
  if (complete && std::abs(value) <= std::numeric_limits<float>::max()) return value;
  p_ = begin;
  const bool is_number = complete || status == NumberStatus::too_large;
  fail(fmt::format("{} is {}, {}", what, quoted_word(),
                   is_number ? "which is too large" : "which is not a finite number"),
       is_number ? "" : "numbers look like -12.5 or 1e-3, with a point");
}

bool LineCursor::integer(std::int64_t& value) {
  return parse_integer(p_, value);
}

Location LineCursor::here() const {
  return {.file = file_, .line = line_, .column = static_cast<int>(p_ - line_begin_) + 1};
}

void LineCursor::fail(std::string problem, std::string hint) const {
  throw Error(here(), std::move(problem), std::move(hint));
}

std::string LineCursor::quoted_word() const {
  constexpr std::size_t longest = 40;
  LineCursor copy = *this;
  const std::string_view word = copy.word();
  std::string text = "'";
  for (const char c : word.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte < 0x20 || byte == 0x7f ? fmt::format("\\x{:02x}", byte) : std::string(1, c);
  }
  return text + (word.size() > longest ? "...'" : "'");
}

}  // namespace lapidary::import
