#include "schema/range.h"

#include <fmt/format.h>

namespace lapidary::schema {

std::string Range::text() const {
  const bool below = min > -infinity, above = max < infinity;
  if (below && above && min_end == End::closed && max_end == End::closed) {
    return fmt::format("from {} to {}", min, max);
  }
  std::string text;
  if (below) text = fmt::format("{} {}", min_end == End::closed ? "at least" : "greater than", min);
  if (below && above) text += " and ";
  if (above) text += fmt::format("{} {}", max_end == End::closed ? "at most" : "less than", max);
  return text;
}

}  // namespace lapidary::schema
