#pragma once

#include <memory>
#include <vector>

#include "distributed/channel.h"

namespace lapidary::distributed {

/// Channels of ranks that are threads of this process: the one of rank i is the i-th. `ranks` >= 1.
/// Messages leave one at a time, each with a call of `poll`: who does not look after them is found.
std::vector<std::unique_ptr<Channel>> local_channels(int ranks);

}  // namespace lapidary::distributed
