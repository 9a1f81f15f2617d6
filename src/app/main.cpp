#include <exception>
#include <new>
#include <string>
#include <variant>
#include <vector>

#include "app/command_line.h"
#include "app/commands.h"
#include "app/different_picture.h"
#include "app/messages.h"
#include "base/error.h"
#include "distributed/mpi_channel.h"

namespace lapidary::app {
namespace {

/// Of several processes with one command line the first one is enough to say what is wrong.
void tell(const Location& where, std::string_view problem, std::string_view hint) {
  if (distributed::launch_of_environment().rank == 0) print_error(where, problem, hint);
}

/// Everything that can go wrong becomes one message and an exit code here.
ExitCode run_program(std::vector<std::string> arguments) {
  try {
    const Command command = parse_command_line(std::move(arguments));
    return std::visit([](const auto& c) { return run(c); }, command);
  } catch (const UsageError& error) {
    tell({}, error.what(), error.hint());
    return ExitCode::usage;
  } catch (const DifferentPicture& error) {
    tell({}, error.what(), error.hint());
    return ExitCode::different;
  } catch (const Error& error) {
    tell(error.where(), error.problem(), error.hint());
    return ExitCode::bad_input;
  } catch (const std::bad_alloc&) {
    tell({}, "there is not enough memory for this",
         "a smaller --size, fewer triangles or smaller images need less");
    return ExitCode::bad_input;
  } catch (const std::exception& error) {
    tell({}, std::string("internal error: ") + error.what(), "please report this");
    return ExitCode::internal_error;
  }
}

}  // namespace
}  // namespace lapidary::app

int main(int argc, char** argv) {
  const auto code = lapidary::app::run_program({argv + 1, argv + argc});
  return static_cast<int>(code);
}
