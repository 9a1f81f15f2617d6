#include "distributed/run_thread.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "distributed/byte_stream.h"

namespace lapidary::distributed {
namespace {

using Clock = std::chrono::steady_clock;
using film::PassRange;
using render::SamplePlan;

std::optional<SamplePlan> first_plan(const Equipment& equipment) {
  if (equipment.renderer.sampling() == render::Sampling::uniform) return std::nullopt;
  return SamplePlan(equipment.renderer.photon_share(), equipment.settings.width,
                    equipment.settings.height);
}

}  // namespace

RunThread::RunThread(const Equipment& equipment)
    : equipment_(equipment), plan_(first_plan(equipment)), thread_([this] { work(); }) {}

RunThread::~RunThread() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
    is_given_up_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void RunThread::add(const PassRange& run) {
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(run);
  }
  changed_.notify_all();
}

void RunThread::drop(const PassRange& run) {
  const std::lock_guard lock(mutex_);
  std::erase(waiting_, run);
  if (running_ == run) is_given_up_ = true;
}

void RunThread::learn(Decision decision) {
  {
    const std::lock_guard lock(mutex_);
    if (!plan_ || plan_->epochs().size() != decision.epoch) ByteReader::fail();
    std::vector<render::Allocation> epochs = plan_->epochs();
    epochs.push_back(std::move(decision.allocation));
    plan_.emplace(plan_->photons(), equipment_.settings.width, equipment_.settings.height,
                  std::move(epochs));
  }
  changed_.notify_all();
}

void RunThread::finish() {
  const std::lock_guard lock(mutex_);
  waiting_.clear();
  is_finishing_ = running_.has_value();
}

std::optional<RenderedRun> RunThread::take() {
  const std::lock_guard lock(mutex_);
  if (problem_) std::rethrow_exception(problem_);
  if (rendered_.empty()) return std::nullopt;
  RenderedRun first = std::move(rendered_.front());
  rendered_.pop_front();
  return first;
}

bool RunThread::is_idle() const {
  const std::lock_guard lock(mutex_);
  return waiting_.empty() && !running_ && rendered_.empty();
}

bool RunThread::can_begin() const {
  return !waiting_.empty() && (!plan_ || waiting_.front().begin < plan_->known_until());
}

void RunThread::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_ending_ || can_begin(); });
    if (is_ending_) return;
    running_ = waiting_.front();
    waiting_.pop_front();
    is_given_up_ = false;
    const PassRange run = *running_;
    lock.unlock();
    try {
      look_up_map(run);
      render(run);
      lock.lock();
    } catch (const std::bad_alloc&) {
      lock.lock();
      problem_ = std::current_exception();
    }
    running_.reset();
    is_finishing_ = false;
  }
}

void RunThread::look_up_map(const PassRange& run) {
  const std::uint64_t end = SamplePlan::epoch_end(run.begin);
  if (end == map_end_) return;
  const std::lock_guard lock(mutex_);
  if (!plan_) return;
  map_ = plan_->map(run.begin);
  map_end_ = end;
}

void RunThread::render(const PassRange& run) {
  const auto& [renderer, settings, pool] = equipment_;
  const std::uint32_t size = render::passes_per_block(settings.width, settings.height);
  const Clock::time_point start = Clock::now();
  RenderedRun rendered{run, film::Film(settings), {}, 0};
  for (std::uint32_t begin = run.begin; begin < run.end; begin += size) {
    if (is_finishing_ && begin > run.begin) break;
    const PassRange block{begin, std::min(begin + size, run.end)};
    rendered.tally += renderer.render(block, map_, rendered.film, pool, {&is_given_up_});
    if (is_given_up_) return;
  }
  const std::chrono::duration<double> seconds = Clock::now() - start;
  rendered.block_seconds = seconds.count() / static_cast<double>(rendered.film.blocks());
  const std::lock_guard lock(mutex_);
  // Once more: `drop` may have come in between.
  if (!is_given_up_) rendered_.push_back(std::move(rendered));
}

}  // namespace lapidary::distributed
