#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.h"
#include "schema/call_site.h"
#include "schema/range.h"

namespace lapidary::schema {

class Context;

/// Decides which files a scene may read.
class FileAccess {
 public:
  virtual ~FileAccess() = default;
  /// The file that a scene calls `written`; fails through `context` when it does not exist or
  /// must not be read.
  virtual std::filesystem::path resolve(std::string_view written, const Context& context) const = 0;
};

/// One use of a node in a scene.
struct Call {
  std::string_view node;  ///< its name, e.g. "sphere"
  CallSite where;
  const FileAccess* files = nullptr;  ///< null: nothing can be read
};

/// Which value is being read, for messages: a node's parameter, or a part of one. Lives on the
/// stack of those who read; each level refers to the one around it.
class Context {
 public:
  explicit Context(const Call& call) : call_(&call) {}

  /// The part called `key`; its numbers must lie in `range`.
  Context at(std::string_view key, const Range& range) const {
    return Context(*this, key, 0, range);
  }
  Context at(std::string_view key) const { return at(key, *range_); }
  /// The part at `index`, from 0; shown from 1 as Lua counts.
  Context at(std::size_t index) const { return Context(*this, {}, index + 1, *range_); }

  const Call& call() const { return *call_; }
  const Range& range() const { return *range_; }
  /// "render.size[2]"; empty for the node itself.
  std::string path() const;
  /// `problem` as the rest of a sentence about the value, as in "must be a number": throws
  /// "radius of sphere must be a number".
  [[noreturn]] void fail(std::string_view problem, std::string hint = "") const;
  /// `problem` as a whole sentence.
  Error error(std::string problem, std::string hint = "") const;

 private:
  Context(const Context& parent, std::string_view key, std::size_t index, const Range& range)
      : call_(parent.call_), parent_(&parent), key_(key), index_(index), range_(&range) {}

  const Call* call_;
  const Context* parent_ = nullptr;
  std::string_view key_;
  std::size_t index_ = 0;
  const Range* range_ = &any_number;
};

}  // namespace lapidary::schema
