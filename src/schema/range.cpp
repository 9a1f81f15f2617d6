#include "schema/range.h"

#include <fmt/format.h>

namespace lapidary::schema {

namespace {

/// 1e12 rather than 1000000000000 or 1e+12.
std::string shown(double x) {
  std::string text = fmt::format("{}", x);
  if (text.ends_with("000000")) text = fmt::format("{:g}", x);
  if (const std::size_t plus = text.find('+'); plus != std::string::npos) text.erase(plus, 1);
  return text;
}

}  // namespace

std::string Range::text() const {
  const bool below = min > -infinity, above = max < infinity;
  if (below && above && min_end == End::closed && max_end == End::closed) {
    return fmt::format("from {} to {}", shown(min), shown(max));
  }
  std::string text;
  if (below)
    text = fmt::format("{} {}", min_end == End::closed ? "at least" : "greater than", shown(min));
  if (below && above) text += " and ";
  if (above)
    text += fmt::format("{} {}", max_end == End::closed ? "at most" : "less than", shown(max));
  return text;
}

}  // namespace lapidary::schema
