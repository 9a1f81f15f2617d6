#include "distributed/crew.h"

#include <chrono>
#include <utility>

#include "distributed/file_message.h"

namespace lapidary::distributed {
namespace {

/// A block that is given up ends soon, but its photons are traced to the end.
constexpr double patience = 60;

}  // namespace

Crew::~Crew() {
  wait(patience);
}

void Crew::send_files(const FileAnswers& answers) {
  send_on(channel_, file_message(answers));
  // Afterwards nobody looks after messages for a while, and long ones would stand still.
  while (channel_.is_busy()) {
    if (auto received = channel_.poll()) early_.push_back(std::move(*received));
    nap(channel_);
  }
}

std::optional<Received> Crew::poll() {
  if (early_.empty()) return channel_.poll();
  Received first = std::move(early_.front());
  early_.pop_front();
  return first;
}

void Crew::dismiss() {
  if (is_dismissed_) return;
  is_dismissed_ = true;
  send_on(channel_, {Topic::end});
  for (int rank = 1; rank < ranks(); ++rank) channel_.send(rank, {Topic::leave});
}

bool Crew::wait(double seconds) {
  using Clock = std::chrono::steady_clock;
  dismiss();
  const Clock::time_point start = Clock::now();
  while (gone_ < ranks() - 1 || channel_.is_busy()) {
    // What was rendered too late is received, and forgotten.
    const auto received = poll();
    if (received && received->message.topic == Topic::bye) ++gone_;
    if (received) continue;
    if (std::chrono::duration<double>(Clock::now() - start).count() > seconds) return false;
    nap(channel_);
  }
  return true;
}

}  // namespace lapidary::distributed
