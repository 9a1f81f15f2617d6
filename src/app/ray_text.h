#pragma once

#include <string_view>

#include "app/command_line.h"

namespace lapidary::app {

/// Six numbers, origin and direction, separated by commas or white space.
///
/// Throws std::invalid_argument, whose text goes on from "it": "takes six numbers ...", unless they
/// are finite, the direction is not zero, and no magnitude is out of reach of double precision.
ProbeCommand::Ray parse_ray(std::string_view text);

}  // namespace lapidary::app
