#include "schema/context.h"

#include <fmt/format.h>

namespace lapidary::schema {

std::string Context::path() const {
  if (!parent_) return "";
  std::string path = parent_->path();
  if (key_.empty()) return fmt::format("{}[{}]", path, index_);
  return path.empty() ? std::string(key_) : fmt::format("{}.{}", path, key_);
}

void Context::fail(std::string_view problem, std::string hint) const {
  const std::string part = path();
  std::string subject(call_->node);
  if (part.starts_with('[')) {
    subject = fmt::format("value {} of {}", part, call_->node);
  } else if (!part.empty()) {
    subject = fmt::format("{} of {}", part, call_->node);
  }
  throw error(fmt::format("{} {}", subject, problem), std::move(hint));
}

Error Context::error(std::string problem, std::string hint) const {
  return Error(call_->where.location(path()), std::move(problem), std::move(hint));
}

}  // namespace lapidary::schema
