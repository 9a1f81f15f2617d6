// What a parallel loop costs before it has done anything.

#include <atomic>

#include "base/parallel.h"
#include "report.h"

int main() {
  using namespace lapidary;
  constexpr std::size_t loops = 2000;
  ThreadPool pool;
  std::atomic<std::size_t> sum = 0;
  const double seconds = bench::best_seconds(5, [&] {
    for (std::size_t i = 0; i < loops; ++i) {
      pool.parallel_for(64, 1, [&](IndexRange piece) { sum += piece.begin; });
    }
  });
  bench::report("base.parallel_loop", seconds / loops * 1e6, "us");
  return sum == 0;
}
