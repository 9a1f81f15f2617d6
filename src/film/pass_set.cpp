#include "film/pass_set.h"

#include <algorithm>
#include <cassert>
#include <charconv>

namespace lapidary::film {
namespace {

/// Takes a number from the front of `text`.
std::optional<std::uint32_t> take_number(std::string_view& text) {
  std::uint32_t value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

}  // namespace

void PassSet::add(const PassRange& range) {
  if (range.is_empty()) return;
  assert(std::none_of(ranges_.begin(), ranges_.end(), [&](const PassRange& r) {
    return r.begin < range.end && range.begin < r.end;
  }));
  const auto after = std::find_if(ranges_.begin(), ranges_.end(),
                                  [&](const PassRange& r) { return r.begin >= range.end; });
  const auto at = ranges_.insert(after, range);
  const auto next = at + 1;
  if (next != ranges_.end() && next->begin == at->end) {
    at->end = next->end;
    ranges_.erase(next);
  }
  if (at != ranges_.begin() && (at - 1)->end == at->begin) {
    (at - 1)->end = at->end;
    ranges_.erase(at);
  }
}

void PassSet::add(const PassSet& other) {
  for (const PassRange& range : other.ranges_) add(range);
}

std::uint64_t PassSet::count() const {
  std::uint64_t sum = 0;
  for (const PassRange& range : ranges_) sum += range.size();
  return sum;
}

bool PassSet::overlaps(const PassSet& other) const {
  auto a = ranges_.begin(), b = other.ranges_.begin();
  while (a != ranges_.end() && b != other.ranges_.end()) {
    if (a->begin < b->end && b->begin < a->end) return true;
    a->end <= b->end ? ++a : ++b;
  }
  return false;
}

std::uint32_t PassSet::first_missing(std::uint32_t from) const {
  for (const PassRange& range : ranges_) {
    if (from < range.begin) break;
    if (from < range.end) return range.end;
  }
  return from;
}

PassSet PassSet::gaps_before(std::uint32_t end) const {
  PassSet gaps;
  std::uint32_t from = 0;
  for (const PassRange& range : ranges_) {
    gaps.add(PassRange{from, std::min(range.begin, end)});
    from = range.end;
  }
  gaps.add(PassRange{from, end});
  return gaps;
}

std::string to_text(const PassSet& passes) {
  std::string text;
  for (const PassRange& range : passes.ranges()) {
    if (!text.empty()) text += ',';
    text += std::to_string(range.begin) + '-' + std::to_string(range.end);
  }
  return text;
}

std::optional<PassSet> parse_pass_set(std::string_view text) {
  PassSet set;
  while (!text.empty()) {
    if (!set.is_empty()) {
      if (text.front() != ',') return std::nullopt;
      text.remove_prefix(1);
    }
    const auto begin = take_number(text);
    if (!begin || text.empty() || text.front() != '-') return std::nullopt;
    text.remove_prefix(1);
    const auto end = take_number(text);
    const bool is_next = end && *begin < *end && (set.is_empty() || *begin > set.end());
    if (!is_next) return std::nullopt;
    set.add(PassRange{*begin, *end});
  }
  return set;
}

}  // namespace lapidary::film
