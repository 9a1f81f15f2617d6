#pragma once

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

  /// What this rank found in the files of the scene.
  void send_files(const FileAnswers& answers);

  /// Tells all to leave whatever they do; once is enough.
  void dismiss();
  /// Dismisses them and waits until they are gone, or for so many seconds. Whether they are gone.
  bool wait(double seconds);

 private:
  Channel& channel_;
  bool is_dismissed_ = false;
  int gone_ = 0;
};

}  // namespace lapidary::distributed
