#pragma once

#include "app/command_line.h"
#include "app/exit_code.h"

namespace lapidary::app {

/// Each carries out one verb, printing what the user is to see. Throws Error for wrong input and
/// UsageError for a wrong option that only shows once input has been read.
ExitCode run(const RenderCommand& command);
ExitCode run(const MergeCommand& command);
ExitCode run(const BakeCommand& command);
ExitCode run(const CheckCommand& command);
ExitCode run(const ProbeCommand& command);
ExitCode run(const CompareCommand& command);
ExitCode run(const HelpCommand& command);
ExitCode run(const ShowText& command);

}  // namespace lapidary::app
