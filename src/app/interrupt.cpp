#include "app/interrupt.h"

#include <csignal>

#include <unistd.h>

#include "app/exit_code.h"

namespace lapidary::app {
namespace {

// A signal handler reaches nothing but what is global.
std::atomic<bool> interrupt_requested = false;
static_assert(std::atomic<bool>::is_always_lock_free);

void on_signal(int) {
  if (interrupt_requested.exchange(true)) _exit(static_cast<int>(ExitCode::interrupted));
}

void handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;  // files being written must not see a short write
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

InterruptGuard::InterruptGuard() {
  interrupt_requested = false;
  handle(on_signal);
}

InterruptGuard::~InterruptGuard() {
  // Once asked to stop, the program is on its way out: asked again, it still ends by its own code.
  if (!interrupt_requested) handle(SIG_DFL);
}

const std::atomic<bool>& InterruptGuard::requested() const {
  return interrupt_requested;
}

}  // namespace lapidary::app
