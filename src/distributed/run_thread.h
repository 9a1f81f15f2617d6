#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/parallel.h"
#include "distributed/film_message.h"
#include "film/film.h"
#include "render/block.h"
#include "render/sample_plan.h"

namespace lapidary::distributed {

/// What a rank renders, and with what.
struct Equipment {
  const render::BlockRenderer& renderer;
  film::Film::Settings settings;
  ThreadPool& pool;
};

/// Renders runs of passes in a thread of its own, one after the other, so that another one is free
/// to talk to other ranks. The pool is this thread's as long as there are runs.
class RunThread {
 public:
  explicit RunThread(const Equipment& equipment);
  /// Gives up what is running.
  ~RunThread();
  RunThread(const RunThread&) = delete;
  RunThread& operator=(const RunThread&) = delete;

  /// Puts a run of whole blocks of one epoch behind those that wait. It waits for its decision.
  void add(const film::PassRange& run);
  /// Forgets a run, or gives it up; it is not delivered. Nothing if it was.
  void drop(const film::PassRange& run);
  /// The next decision of adaptive sampling. Throws Error if it is not the next.
  void learn(Decision decision);
  /// Forgets what waits, and lets the running block be the last of its run, which is delivered.
  void finish();

  /// What has been rendered, in its order; nothing if there is nothing new. Throws bad_alloc where
  /// there was no memory for it.
  std::optional<RenderedRun> take();
  /// Whether nothing runs, nothing waits and nothing is to be taken.
  bool is_idle() const;

 private:
  void work();
  bool can_begin() const;
  void render(const film::PassRange& run);
  void look_up_map(const film::PassRange& run);

  Equipment equipment_;
  mutable std::mutex mutex_;  // of all that follows
  std::condition_variable changed_;
  std::deque<film::PassRange> waiting_;
  std::optional<film::PassRange> running_;
  std::deque<RenderedRun> rendered_;
  std::optional<render::SamplePlan> plan_;
  std::exception_ptr problem_;
  std::atomic<bool> is_given_up_ = false;   // the running run
  std::atomic<bool> is_finishing_ = false;  // the same, after a block
  bool is_ending_ = false;
  // Of the thread alone.
  render::SampleMap map_;
  std::uint64_t map_end_ = 0;  ///< of the epoch that it is for
  std::thread thread_;
};

}  // namespace lapidary::distributed
