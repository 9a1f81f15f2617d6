#pragma once

#include <mutex>
#include <string>
#include <vector>

#include "base/error.h"

namespace lapidary {

/// Something the user should know that does not stop the work.
struct Warning {
  Location where;
  std::string text;
};

/// "where: text".
std::string to_string(const Warning& warning);

/// Collects warnings from any thread for the application to print: nothing below `app/` prints.
class WarningLog {
 public:
  void add(Location where, std::string text);

  /// Takes everything collected so far, in the order it came.
  std::vector<Warning> take();

 private:
  std::mutex mutex_;
  std::vector<Warning> warnings_;
};

}  // namespace lapidary
