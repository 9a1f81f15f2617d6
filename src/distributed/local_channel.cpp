#include "distributed/local_channel.h"

#include <cassert>
#include <deque>
#include <mutex>
#include <utility>

namespace lapidary::distributed {
namespace {

/// What has arrived for one rank.
struct Mailbox {
  std::mutex mutex;
  std::deque<Received> messages;
};

using Mailboxes = std::vector<Mailbox>;

class LocalChannel : public Channel {
 public:
  LocalChannel(int rank, std::shared_ptr<Mailboxes> boxes)
      : rank_(rank), boxes_(std::move(boxes)) {}

  int rank() const override { return rank_; }
  int ranks() const override { return static_cast<int>(boxes_->size()); }

  void send(int to, Message message) override {
    assert(to >= 0 && to < ranks());
    if (!message.bytes) message.bytes = std::make_shared<const Bytes>();
    leaving_.emplace_back(to, std::move(message));
  }

  std::optional<Received> poll() override {
    if (!leaving_.empty()) {
      auto& [to, message] = leaving_.front();
      Mailbox& there = box_of(to);
      const std::lock_guard lock(there.mutex);
      there.messages.push_back({rank_, std::move(message), 0.0});
      leaving_.pop_front();
    }
    Mailbox& box = box_of(rank_);
    const std::lock_guard lock(box.mutex);
    if (box.messages.empty()) return std::nullopt;
    Received first = std::move(box.messages.front());
    box.messages.pop_front();
    return first;
  }

  bool is_busy() const override { return !leaving_.empty(); }

 private:
  Mailbox& box_of(int rank) { return (*boxes_)[static_cast<std::size_t>(rank)]; }

  std::deque<std::pair<int, Message>> leaving_;
  int rank_;
  std::shared_ptr<Mailboxes> boxes_;
};

}  // namespace

std::vector<std::unique_ptr<Channel>> local_channels(int ranks) {
  const auto boxes = std::make_shared<Mailboxes>(static_cast<std::size_t>(ranks));
  std::vector<std::unique_ptr<Channel>> channels;
  for (int rank = 0; rank < ranks; ++rank) {
    channels.push_back(std::make_unique<LocalChannel>(rank, boxes));
  }
  return channels;
}

}  // namespace lapidary::distributed
