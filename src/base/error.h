#pragma once

#include <stdexcept>
#include <string>

namespace lapidary {

/// Where in the user's input something stands. Empty or zero members are unknown.
struct Location {
  std::string file;
  int line = 0;           ///< from 1
  int column = 0;         ///< from 1, in bytes
  std::string parameter;  ///< the parameter of a node, e.g. "radius"

  bool operator==(const Location&) const = default;
};

/// "file:line:column" with unknown parts left out; empty when nothing is known.
std::string to_string(const Location& where);

/// What is wrong with the user's input: where it stands, what is wrong, what to do about it.
///
/// Thrown while a scene is loaded and built, never while it is rendered. `what()` is the whole
/// message: "where: problem (hint)".
class Error : public std::runtime_error {
 public:
  Error(Location where, std::string problem, std::string hint = "");

  const Location& where() const { return where_; }
  const std::string& problem() const { return problem_; }
  const std::string& hint() const { return hint_; }

 private:
  Location where_;
  std::string problem_;
  std::string hint_;
};

/// The error of a file that cannot be used as a whole.
Error file_error(const std::string& file, std::string problem, std::string hint = "");

}  // namespace lapidary
