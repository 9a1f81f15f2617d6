#include "base/error.h"

#include <fmt/format.h>

namespace lapidary {
namespace {

std::string whole_message(const Location& where, const std::string& problem,
                          const std::string& hint) {
  std::string message = to_string(where);
  if (!message.empty()) message += ": ";
  message += problem;
  if (!hint.empty()) message += fmt::format(" ({})", hint);
  return message;
}

}  // namespace

std::string to_string(const Location& where) {
  std::string text = where.file;
  if (where.line > 0) text += fmt::format("{}{}", text.empty() ? "line " : ":", where.line);
  if (where.line > 0 && where.column > 0) text += fmt::format(":{}", where.column);
  return text;
}

Error::Error(Location where, std::string problem, std::string hint)
    : std::runtime_error(whole_message(where, problem, hint)),
      where_(std::move(where)),
      problem_(std::move(problem)),
      hint_(std::move(hint)) {}

Error file_error(const std::string& file, std::string problem, std::string hint) {
  return Error(Location{.file = file}, std::move(problem), std::move(hint));
}

}  // namespace lapidary
