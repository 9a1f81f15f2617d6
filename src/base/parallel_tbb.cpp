#include <algorithm>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "base/parallel.h"

namespace lapidary {

struct ThreadPool::State {
  explicit State(int threads)
      : limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)),
        arena(threads) {}

  tbb::global_control limit;  // also bounds the arenas that Embree makes for itself
  tbb::task_arena arena;
};

ThreadPool::ThreadPool(int threads)
    : state_(std::make_unique<State>(threads > 0 ? threads : tbb::info::default_concurrency())) {}

ThreadPool::~ThreadPool() = default;

int ThreadPool::threads() const {
  return state_->arena.max_concurrency();
}

void ThreadPool::parallel_for(std::size_t count, std::size_t grain,
                              const std::function<void(IndexRange)>& body) {
  const tbb::blocked_range<std::size_t> all(0, count, std::max<std::size_t>(grain, 1));
  state_->arena.execute([&] {
    tbb::parallel_for(
        all,
        [&](const tbb::blocked_range<std::size_t>& piece) {
          body({piece.begin(), piece.end()});
        },
        tbb::simple_partitioner());
  });
}

void ThreadPool::run_inside(const std::function<void()>& work) {
  state_->arena.execute(work);
}

}  // namespace lapidary
