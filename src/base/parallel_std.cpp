#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/parallel.h"

namespace lapidary {

struct ThreadPool::State {
  int threads = 1;
};

namespace {

/// Hands out pieces of [0, count) until all are taken or one has failed.
class Pieces {
 public:
  Pieces(std::size_t count, std::size_t grain, const std::function<void(IndexRange)>& body)
      : count_(count), grain_(grain), body_(body) {}

  void work() {
    while (!failed_) {
      const std::size_t begin = next_.fetch_add(grain_);
      if (begin >= count_) return;
      try {
        body_({begin, std::min(begin + grain_, count_)});
      } catch (...) {
        const std::lock_guard lock(mutex_);
        if (!failed_.exchange(true)) error_ = std::current_exception();
      }
    }
  }

  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::size_t count_;
  std::size_t grain_;
  const std::function<void(IndexRange)>& body_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::exception_ptr error_;
};

thread_local bool inside_loop = false;  // an inner loop runs on the thread that starts it

}  // namespace

ThreadPool::ThreadPool(int threads) : state_(std::make_unique<State>()) {
  state_->threads =
      threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

ThreadPool::~ThreadPool() = default;

int ThreadPool::threads() const {
  return state_->threads;
}

void ThreadPool::parallel_for(std::size_t count, std::size_t grain,
                              const std::function<void(IndexRange)>& body) {
  const std::size_t piece = std::max<std::size_t>(grain, 1);
  const std::size_t pieces_needed = (count + piece - 1) / piece;
  Pieces pieces(count, piece, body);
  const std::size_t helpers =
      inside_loop || pieces_needed < 2
          ? 0
          : std::min<std::size_t>(static_cast<std::size_t>(threads()), pieces_needed) - 1;
  const bool was_inside = inside_loop;
  {
    std::vector<std::jthread> team;
    for (std::size_t i = 0; i < helpers; ++i) {
      team.emplace_back([&pieces] {
        inside_loop = true;
        pieces.work();
      });
    }
    inside_loop = true;
    pieces.work();
    inside_loop = was_inside;
  }
  pieces.rethrow();
}

void ThreadPool::run_inside(const std::function<void()>& work) {
  work();
}

}  // namespace lapidary
