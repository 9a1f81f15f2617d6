#include "distributed/channel.h"

#include <chrono>
#include <thread>

namespace lapidary::distributed {

void send_on(Channel& channel, const Message& message) {
  const int first = 2 * channel.rank() + 1;
  for (int to = first; to < first + 2 && to < channel.ranks(); ++to) channel.send(to, message);
}

void nap(const Channel& channel) {
  // Long messages move a piece at a time.
  constexpr std::chrono::microseconds often(20), seldom(1000);
  std::this_thread::sleep_for(channel.is_busy() ? often : seldom);
}

}  // namespace lapidary::distributed
