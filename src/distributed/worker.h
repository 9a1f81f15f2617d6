#pragma once

#include <string_view>

#include "distributed/orders.h"
#include "distributed/run_thread.h"

namespace lapidary::distributed {

/// Renders what rank 0 asks for until it says that it is over, and takes leave. Throws Error for
/// messages that make no sense, and bad_alloc: then rank 0 is to be told (`fail`).
void work(Orders& orders, const Equipment& equipment);

/// Tells rank 0 why this rank cannot work, waits until it says that it is over, and takes leave.
void fail(Orders& orders, std::string_view why);

}  // namespace lapidary::distributed
