#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lapidary::film {

/// A half-open range of passes over the whole picture: the unit of progress, of stopping, and of
/// anything that renders part of a picture. A pass is at least one camera sample for every pixel.
struct PassRange {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;

  std::uint32_t size() const { return end - begin; }
  bool is_empty() const { return begin >= end; }
  bool operator==(const PassRange&) const = default;
};

/// Which passes a film holds.
class PassSet {
 public:
  PassSet() = default;
  PassSet(const PassRange& range) { add(range); }  // NOLINT: a range is a set of passes

  /// Precondition: none of them is there yet.
  void add(const PassRange& range);
  void add(const PassSet& other);

  bool is_empty() const { return ranges_.empty(); }
  std::uint64_t count() const;
  bool overlaps(const PassSet& other) const;
  /// The least pass, and the one after the greatest; of a set that is not empty.
  std::uint32_t begin() const { return ranges_.front().begin; }
  std::uint32_t end() const { return ranges_.back().end; }
  /// The first pass from `from` on that is missing.
  std::uint32_t first_missing(std::uint32_t from = 0) const;
  /// What is missing before `end`.
  PassSet gaps_before(std::uint32_t end) const;

  /// Ascending, none empty, with a gap between any two.
  const std::vector<PassRange>& ranges() const { return ranges_; }

  bool operator==(const PassSet&) const = default;

 private:
  std::vector<PassRange> ranges_;
};

/// "0-16,20-24": begin and end of every range.
std::string to_text(const PassSet& passes);
/// The set that `to_text` wrote; nothing for any other text.
std::optional<PassSet> parse_pass_set(std::string_view text);

}  // namespace lapidary::film
