#pragma once

#include <deque>
#include <optional>

#include "base/input_files.h"
#include "distributed/channel.h"

namespace lapidary::distributed {

/// The ranks that work for rank 0, as rank 0 sees them. They are sent home at the end, whatever it
/// was that ended.
class Crew {
 public:
  /// `channel` is rank 0's and must outlive this.
  explicit Crew(Channel& channel) : channel_(channel) {}
  ~Crew();
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  Channel& channel() const { return channel_; }
  int ranks() const { return channel_.ranks(); }

  /// Sends what this rank found in the files of the scene, and returns when it is on its way to
  /// all.
  void send_files(const FileAnswers& answers);

  /// A message that has arrived; nothing if there is none.
  std::optional<Received> poll();

  /// Tells all to leave whatever they do; once is enough.
  void dismiss();
  /// Dismisses them and waits until they are gone, or for so many seconds. Whether they are gone.
  bool wait(double seconds);

 private:
  Channel& channel_;
  std::deque<Received> early_;  ///< what came while something else was to be done
  bool is_dismissed_ = false;
  int gone_ = 0;
};

}  // namespace lapidary::distributed
