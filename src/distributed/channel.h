#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace lapidary::distributed {

using Bytes = std::vector<std::byte>;

/// What a message is about. Rank 0 is the one that all others work for.
enum class Topic : std::uint8_t {
  job,     ///< from 0, for all: the files of the scene
  ready,   ///< to 0: can render it, with what it has made of it
  failed,  ///< to 0: cannot, and why
  epoch,   ///< from 0, for all: a decision of adaptive sampling
  run,     ///< from 0: passes to render
  drop,    ///< from 0: passes that need not be rendered any more
  film,    ///< to 0: passes that were rendered
  finish,  ///< from 0, for all: the running block is the last
  idle,    ///< to 0: it was
  end,     ///< from 0, for all: whatever it is, leave it
  leave,   ///< from 0: the last that is for one
  bye,     ///< to 0: nothing comes after this
};
inline constexpr std::uint8_t topics = static_cast<std::uint8_t>(Topic::bye) + 1;

/// The bytes are shared, as the same go to many.
struct Message {
  Topic topic = Topic::end;
  std::shared_ptr<const Bytes> bytes = nullptr;  ///< null: none
};

struct Received {
  int from = 0;
  Message message;     ///< with bytes, if only none
  double seconds = 0;  ///< that it took to arrive once it had begun to
};

/// Carries messages between the ranks of a job, which may be processes on many machines. All of it
/// belongs to one thread of a rank. Messages from one rank to another arrive in their order.
class Channel {
 public:
  virtual ~Channel() = default;

  virtual int rank() const = 0;
  virtual int ranks() const = 0;

  /// Returns at once, long before the message is there.
  virtual void send(int to, Message message) = 0;

  /// A message that has arrived whole, from anybody, and none if there is none. Only here messages
  /// move on, those that were sent as well: to be called again and again.
  virtual std::optional<Received> poll() = 0;

  /// Whether something is on its way from or to here, as far as is known.
  virtual bool is_busy() const = 0;
};

/// Sends what is for all on to others, each of which does so again: all ranks get it after a number
/// of steps that grows with the logarithm of theirs. To be called by rank 0 to begin with. All
/// that is sent on arrives everywhere in one order.
void send_on(Channel& channel, const Message& message);

/// Waits until it may be worth asking again whether anything has arrived: the threads that render
/// have the processor meanwhile.
void nap(const Channel& channel);

}  // namespace lapidary::distributed
