#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace lapidary {

/// A half-open range of indices.
struct IndexRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The threads that a program's parallel loops run on.
///
/// Two backends with one meaning, chosen at configure time (LAPIDARY_THREADS): oneTBB, and plain
/// std::thread, so that the thread sanitizer sees only our own code. A loop may be started from
/// inside another loop's body; it then runs on the same threads.
class ThreadPool {
 public:
  /// `threads` >= 1; 0 means one per hardware thread.
  explicit ThreadPool(int threads = 0);
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int threads() const;

  /// Calls `body` on pieces that cover [0, count), each of at most `grain` indices (at least 1), on
  /// all threads, and returns when all are done. The caller's thread takes part. Which thread
  /// gets which piece is unspecified, so `body` must not depend on it. The first exception a body
  /// throws is rethrown here; pieces not yet begun may then be skipped.
  void parallel_for(std::size_t count, std::size_t grain,
                    const std::function<void(IndexRange)>& body);

  /// Runs `work` where libraries that bring their own parallel loops on oneTBB (Embree) use this
  /// pool's threads and no others.
  void run_inside(const std::function<void()>& work);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// The same on this thread alone where there is no pool: in one piece.
inline void parallel_for(ThreadPool* pool, std::size_t count, std::size_t grain,
                         const std::function<void(IndexRange)>& body) {
  if (pool != nullptr) return pool->parallel_for(count, grain, body);
  if (count > 0) body({0, count});
}

}  // namespace lapidary
