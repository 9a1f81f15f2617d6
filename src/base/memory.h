#pragma once

#include <cstdint>

namespace lapidary {

/// Of this machine.
std::uint64_t physical_memory_bytes();

}  // namespace lapidary
