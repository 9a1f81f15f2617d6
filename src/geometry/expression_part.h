#pragma once

#include <cstdint>
#include <vector>

#include "geometry/expression.h"

namespace lapidary::geometry {

/// What one term of an expression is made of, as an expression of its own.
struct ExpressionPart {
  Expression expression;
  Expression::Term root;
  /// The number that each of its leaves has in the whole, ascending: the order of writing is kept.
  std::vector<std::uint32_t> leaf_numbers;
};

/// Time: n log n in the size of the part, whatever the size of the whole.
ExpressionPart part_of(const Expression& whole, Expression::Term root);

}  // namespace lapidary::geometry
