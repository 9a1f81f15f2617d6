#include "distributed/orders.h"

#include <cassert>
#include <utility>

#include "distributed/byte_stream.h"

namespace lapidary::distributed {
namespace {

bool is_for_all(Topic topic) {
  return topic == Topic::job || topic == Topic::epoch || topic == Topic::finish ||
         topic == Topic::end;
}

}  // namespace

std::optional<Message> Orders::poll() {
  while (!are_over()) {
    auto received = channel_.poll();
    if (!received) return std::nullopt;
    Message& message = received->message;
    if (is_for_all(message.topic)) send_on(channel_, message);
    if (message.topic == Topic::end) {
      has_ended_ = true;
    } else if (message.topic == Topic::leave) {
      may_leave_ = true;
    } else {
      return std::move(message);
    }
  }
  return std::nullopt;
}

void Orders::send_all() {
  while (channel_.is_busy()) {
    const bool is_more = are_over() ? channel_.poll().has_value() : poll().has_value();
    if (is_more) ByteReader::fail();
    nap(channel_);
  }
}

void Orders::take_leave() {
  assert(are_over());
  channel_.send(0, {Topic::bye});
  send_all();
}

}  // namespace lapidary::distributed
