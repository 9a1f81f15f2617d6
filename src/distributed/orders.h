#pragma once

#include <optional>

#include "distributed/channel.h"

namespace lapidary::distributed {

/// What rank 0 sends to one that works for it. What is for all is sent on to the others on the way.
class Orders {
 public:
  /// `channel` is not rank 0's and must outlive this.
  explicit Orders(Channel& channel) : channel_(channel) {}

  Channel& channel() const { return channel_; }

  /// What has arrived; nothing if there is nothing, and none but job, run, drop, epoch and finish.
  std::optional<Message> poll();
  /// Waits until what was sent is gone; before this rank does something else for a while. Throws
  /// Error where anything but the end arrives meanwhile.
  void send_all();
  /// Whether rank 0 has nothing more to say, and this rank has to take its leave.
  bool are_over() const { return has_ended_ && may_leave_; }

  /// Tells rank 0 that this rank has come to its end, and waits until all is sent. Precondition:
  /// the orders are over.
  void take_leave();

 private:
  Channel& channel_;
  bool has_ended_ = false;
  bool may_leave_ = false;
};

}  // namespace lapidary::distributed
