#include "base/log.h"

#include <utility>

namespace lapidary {

std::string to_string(const Warning& warning) {
  const std::string place = to_string(warning.where);
  return place.empty() ? warning.text : place + ": " + warning.text;
}

void WarningLog::add(Location where, std::string text) {
  const std::lock_guard lock(mutex_);
  warnings_.push_back({std::move(where), std::move(text)});
}

std::vector<Warning> WarningLog::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(warnings_, {});
}

}  // namespace lapidary
