#include "render/canvas.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <limits>
#include <utility>

namespace lapidary::render {
namespace {

constexpr std::uint64_t without_end = std::numeric_limits<std::uint64_t>::max();

std::optional<SamplePlan> plan_for(const BlockRenderer& renderer,
                                   const film::Film::Settings& settings) {
  if (renderer.sampling() == Sampling::uniform) return std::nullopt;
  return SamplePlan(renderer.photon_share(), settings.width, settings.height);
}

}  // namespace

Canvas::Canvas(const film::Film::Settings& settings, const BlockRenderer& renderer)
    : film_(settings), plan_(plan_for(renderer, settings)) {}

Canvas::Canvas(film::Film film, std::optional<SamplePlan> plan)
    : film_(std::move(film)), plan_(std::move(plan)) {
  take_decisions();
}

std::uint64_t Canvas::samples_known_until() const {
  return plan_ ? plan_->known_until() : without_end;
}

std::uint64_t Canvas::samples_knowable_until() const {
  const bool is_too_late =
      plan_ && !film_.passes().is_empty() && film_.passes().end() > plan_->next_decision();
  return is_too_late ? plan_->known_until() : without_end;
}

const SampleMap& Canvas::map(std::uint32_t pass) {
  static const SampleMap uniform;
  return plan_ ? plan_->map(pass) : uniform;
}

BlockTally Canvas::render(const BlockRenderer& renderer, const PassRange& block, ThreadPool& pool,
                          const Watch& watch) {
  cut_.reset();
  const BlockTally tally = renderer.render(block, map(block.begin), film_, pool, watch);
  take_decisions();
  return tally;
}

BlockTally Canvas::render_cut(const BlockRenderer& renderer, const PassRange& passes,
                              ThreadPool& pool, const Watch& watch) {
  cut_ = film_;
  return renderer.render(passes, map(passes.begin), *cut_, pool, watch);
}

bool Canvas::must_wait(const PassRange& passes) const {
  return samples_knowable_until() == without_end && plan_ && passes.begin >= plan_->next_decision();
}

void Canvas::add(film::Film blocks) {
  cut_.reset();
  if (blocks.passes().is_empty()) return;
  const PassRange passes{blocks.passes().begin(), blocks.passes().end()};
  if (!must_wait(passes)) {
    film_.add(blocks);
  } else {
    const auto [at, is_new] = waiting_.try_emplace(std::bit_floor(passes.begin), std::move(blocks));
    if (!is_new) at->second.add(blocks);
  }
  take_decisions();
}

void Canvas::take_decisions() {
  if (!plan_) return;
  for (std::uint64_t before = 0; plan_->known_until() != before;) {
    before = plan_->known_until();
    while (!waiting_.empty() && waiting_.begin()->first < plan_->next_decision()) {
      film_.add(waiting_.begin()->second);
      waiting_.erase(waiting_.begin());
    }
    plan_->block_done(film_);
  }
}

void Canvas::learn(const SamplePlan& plan) {
  if (!plan_ || plan.known_until() <= plan_->known_until()) return;
  plan_ = plan;
  take_decisions();
}

void Canvas::settle() {
  for (const auto& [begin, film] : waiting_) film_.add(film);
  waiting_.clear();
  take_decisions();
}

bool is_of_whole_blocks(const film::PassSet& passes, int width, int height) {
  const std::uint32_t size = passes_per_block(width, height);
  return std::ranges::all_of(passes.ranges(), [size](const PassRange& range) {
    return range.begin % size == 0 && range.end % size == 0;
  });
}

}  // namespace lapidary::render
