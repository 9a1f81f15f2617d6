#include "geometry/expression.h"

#include <cassert>

namespace lapidary::geometry {

Expression::Term Expression::add(const PlacedSolid& solid, SurfaceTag tag) {
  const auto index = static_cast<std::uint32_t>(leaves_.size());
  assert(index < Term::leaf_bit);
  leaves_.push_back({solid, tag, no_parts});
  return Term(index | Term::leaf_bit);
}

Expression::Term Expression::add(Operation operation, std::span<const Term> operands) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  assert(index < Term::leaf_bit);
  nodes_.push_back({operation, static_cast<std::uint32_t>(operands_.size()),
                    static_cast<std::uint32_t>(operands.size())});
  operands_.insert(operands_.end(), operands.begin(), operands.end());
  return Term(index);
}

void Expression::reserve(std::size_t leaves, std::size_t nodes) {
  leaves_.reserve(leaves);
  nodes_.reserve(nodes);
  operands_.reserve(leaves + nodes);
}

}  // namespace lapidary::geometry
