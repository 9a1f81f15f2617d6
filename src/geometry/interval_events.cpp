#include "geometry/interval_events.h"

#include <algorithm>

namespace lapidary::geometry {

void EventBuffer::grow() {
  if (many_.empty()) many_.assign(few_.begin(), few_.end());
  many_.resize(2 * capacity_);
  events_ = many_.data();
  capacity_ = many_.size();
}

}  // namespace lapidary::geometry
