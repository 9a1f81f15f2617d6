#pragma once

#include <cstddef>
#include <cstdint>

namespace lapidary::lua {

/// What a scene may use while it is read. Generous for scenes of millions of solids, and over soon
/// enough for endless loops.
struct Limits {
  /// Instructions of the interpreter; work in library functions is counted in the same coin.
  std::int64_t steps = 1'000'000'000;
  std::size_t memory = std::size_t{2} << 30;         ///< bytes, of tables and nodes together
  std::size_t string_bytes = std::size_t{16} << 20;  ///< of one string
  /// Seconds of processor time: a backstop for what `steps` weighs too lightly.
  double seconds = 300;
};

}  // namespace lapidary::lua
