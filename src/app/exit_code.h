#pragma once

namespace lapidary::app {

/// What the process answers its caller with; documented for users, so the numbers are fixed.
enum class ExitCode {
  done = 0,
  internal_error = 1,  ///< a fault of the program, not of its input
  usage = 2,           ///< the command line makes no sense
  bad_input = 3,       ///< the scene or a file is wrong, or cannot be read or written
  interrupted = 4,     ///< the picture of the finished passes is written
  different = 5,       ///< checkpoints are of another picture than what is to go on or be merged
};

}  // namespace lapidary::app
