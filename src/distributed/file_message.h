#pragma once

#include "base/input_files.h"
#include "distributed/channel.h"

namespace lapidary::distributed {

/// What rank 0 found in the files of a scene, so that no other has to have them.
Message file_message(const FileAnswers& answers);
/// Throws Error for bytes that are no such message.
FileAnswers read_file_message(const Bytes& bytes);

}  // namespace lapidary::distributed
