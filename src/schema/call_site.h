#pragma once

#include <memory>
#include <string>
#include <utility>

#include "base/error.h"

namespace lapidary::schema {

/// Where a node was written: a file, shared by all its nodes, and a line. Small enough to be kept
/// with each of a million nodes.
class CallSite {
 public:
  CallSite() = default;  ///< unknown
  CallSite(std::shared_ptr<const std::string> file, int line)
      : file_(std::move(file)), line_(line) {}

  Location location(std::string parameter = "") const {
    return {.file = file_ ? *file_ : "", .line = line_, .parameter = std::move(parameter)};
  }

 private:
  std::shared_ptr<const std::string> file_;
  int line_ = 0;
};

}  // namespace lapidary::schema
