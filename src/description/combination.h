#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace lapidary::description {

struct Object;
using ObjectPtr = std::shared_ptr<const Object>;

/// How a combination makes one solid of its operands.
enum class SetOperation : std::uint8_t {
  unite,       ///< what is in any of them; without operands nothing
  intersect,   ///< what is in all of them
  subtract,    ///< what is in the first and in no other
  complement,  ///< what is not in the only one
  section,     ///< as subtract, to show the inside: see Object
};

/// An operation and its operands, which stand where they were made. A value: it is cheap to copy,
/// and copies share their operands.
///
/// `p = p - hole` in a loop makes a version of p for every hole. The operands of all versions are
/// the beginnings of one list that the newest version appends to, so that a step takes constant
/// time and the memory of one pointer.
class Combination {
 public:
  /// complement takes one operand, intersect, subtract and section take at least one.
  Combination(SetOperation operation, std::vector<ObjectPtr> operands);

  SetOperation operation() const { return operation_; }
  /// Valid until somebody appends.
  std::span<const ObjectPtr> operands() const { return {list_->operands.data(), size_}; }

  /// The combination of these operands and one more, in amortised constant time. Nothing when
  /// another version has appended already, or when the operand is, or may be, made of a version
  /// itself: the list would hold itself and never be freed.
  std::optional<Combination> appended(const ObjectPtr& operand) const;

  /// The list that versions share: versions of one list that have as many operands are the same.
  const void* list() const { return list_.get(); }
  /// Whether the operands can be reached in another way, too.
  bool is_shared() const { return list_.use_count() > 1; }
  bool operator==(const Combination&) const = default;

 private:
  struct List {
    std::vector<ObjectPtr> operands;
    ~List();
  };

  std::shared_ptr<List> list_;
  std::uint32_t size_;
  SetOperation operation_;
};

/// Gives up what it is handed. Objects that hold objects end with this, so that a tower of them of
/// any height comes down floor by floor and not in one recursion.
void release(std::vector<ObjectPtr>&& objects) noexcept;

}  // namespace lapidary::description
