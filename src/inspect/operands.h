#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/solid_scene.h"

namespace lapidary::inspect {

/// An operand of a combination that seems to be of no use.
struct IdleOperand {
  std::uint32_t number = 0;  ///< from 0 in the order of writing, as Probe counts leaves
  std::string kind;
};

/// What can be said about the operands of a body.
struct OperandReport {
  std::size_t stated = 0;
  std::size_t live = 0;  ///< of them those that can matter anywhere, by their boxes
  /// Live operands that no surface was found of, and how many lines were aimed at each; of more
  /// operands than `examined` the rest was not looked for.
  std::vector<IdleOperand> idle;
  std::size_t lines = 0;
  std::size_t examined = 0;
  /// Of all lines that were followed those along which surfaces could not be told apart, since
  /// rounding at this place is coarser than what is modelled: what they found may be wrong.
  std::size_t cut_lines = 0;
  std::size_t lines_followed = 0;
  /// Whether the body has no surface and nothing inside, as far as these lines say.
  bool empty = false;
};

/// Looks at the operands of the only region of `body`, which is no instance, with lines through
/// random points of their boxes. Where surfaces of several coincide, one of them counts. Lines and
/// result are always the same.
OperandReport examine_operands(const geometry::SolidScene& body);

/// Whether none of a number of lines through the operands finds anything of the only region of
/// `body`. The first that does ends the search.
bool seems_empty(const geometry::SolidScene& body);

}  // namespace lapidary::inspect
