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

namespace lapidary::app {
namespace {

/// Everything that can go wrong becomes one message and an exit code here.
ExitCode run_program(std::vector<std::string> arguments) {
  try {
    const Command command = parse_command_line(std::move(arguments));
    return std::visit([](const auto& c) { return run(c); }, command);
  } catch (const UsageError& error) {
    print_error({}, error.what(), error.hint());
    return ExitCode::usage;
  } catch (const DifferentPicture& error) {
    print_error({}, error.what(), error.hint());
    return ExitCode::different;
  } catch (const Error& error) {
    print_error(error.where(), error.problem(), error.hint());
    return ExitCode::bad_input;
  } catch (const std::bad_alloc&) {
    print_error({}, "there is not enough memory for this",
                "a smaller --size, fewer triangles or smaller images need less");
    return ExitCode::bad_input;
  } catch (const std::exception& error) {
    print_error({}, std::string("internal error: ") + error.what(), "please report this");
    return ExitCode::internal_error;
  }
}

}  // namespace
}  // namespace lapidary::app

int main(int argc, char** argv) {
  const auto code = lapidary::app::run_program({argv + 1, argv + argc});
  return static_cast<int>(code);
}
