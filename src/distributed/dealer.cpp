#include "distributed/dealer.h"

#include <algorithm>
#include <utility>

#include "render/sample_plan.h"

namespace lapidary::distributed {
namespace {

using film::PassRange;
using film::PassSet;

bool has(const std::vector<int>& ranks, int rank) {
  return std::ranges::find(ranks, rank) != ranks.end();
}

/// Where the passes that are missing from `begin` on end.
std::uint64_t gap_end(const PassSet& set, std::uint32_t begin, std::uint64_t end) {
  for (const PassRange& range : set.ranges()) {
    if (range.begin >= begin) return std::min<std::uint64_t>(range.begin, end);
  }
  return end;
}

}  // namespace

Dealer::Dealer(int ranks, std::uint32_t block, PassSet done)
    : ranks_(ranks), block_(block), done_(std::move(done)), taken_(done_) {}

std::optional<PassRange> Dealer::deal(int rank, const Bounds& bounds, Clock::time_point now) {
  const std::uint32_t begin = taken_.first_missing(bounds.begin);
  std::uint64_t end = gap_end(taken_, begin, bounds.end);
  if (begin >= end) return std::nullopt;
  if (bounds.epochs == Bounds::Epochs::are_ends) {
    end = std::min(end, render::SamplePlan::epoch_end(begin));
  }
  // A part of what is left, not an equal share: nobody knows who will be slow.
  const std::uint64_t left = (bounds.end_of_work - begin) / block_;
  const std::uint64_t fair = left / (2 * static_cast<std::uint64_t>(ranks_));
  const std::uint64_t blocks =
      std::clamp<std::uint64_t>(fair, bounds.least_blocks, bounds.most_blocks);
  end = std::min(end, begin + blocks * block_);
  const PassRange run{begin, static_cast<std::uint32_t>(end)};
  taken_.add(run);
  dealt_.push_back({run, {rank}, now});
  return run;
}

bool Dealer::is_first_of(int rank, const Dealt& dealt) const {
  const auto first =
      std::ranges::find_if(dealt_, [rank](const Dealt& other) { return has(other.holders, rank); });
  return &*first == &dealt;
}

std::optional<Dealer::Shared> Dealer::share(int rank, double block_seconds, Clock::time_point now) {
  constexpr double patience = 4;  // of what a run should take; it may have waited for one before it
  constexpr double least = 0.1;   // seconds: of small blocks little is known
  for (Dealt& dealt : dealt_) {
    if (has(dealt.holders, rank)) continue;
    const int holder = dealt.holders.front();
    const std::size_t holders = dealt.holders.size();
    if (holders == 1 && !is_first_of(holder, dealt)) {
      dealt.holders = {rank};
      dealt.since = now;
      return Shared{dealt.run, holder, Shared::Means::instead_of_it};
    }
    const double expected =
        static_cast<double>(holders) * block_seconds * dealt.run.size() / block_;
    const std::chrono::duration<double> taken = now - dealt.since;
    if (taken.count() < patience * expected + least) continue;
    dealt.holders.push_back(rank);
    dealt.since = now;
    return Shared{dealt.run, holder, Shared::Means::beside_it};
  }
  return std::nullopt;
}

std::optional<std::vector<int>> Dealer::done(int rank, const PassRange& run,
                                             const PassSet& passes) {
  std::vector<int> others;
  const auto dealt = std::ranges::find(dealt_, run, &Dealt::run);
  if (dealt != dealt_.end()) {
    others = std::move(dealt->holders);
    std::erase(others, rank);
    dealt_.erase(dealt);
  }
  const bool is_news = !passes.is_empty() && !done_.overlaps(passes);
  if (is_news) done_.add(passes);
  find_taken();
  return is_news ? std::optional(others) : std::nullopt;
}

void Dealer::recall() {
  dealt_.clear();
  find_taken();
}

void Dealer::find_taken() {
  taken_ = done_;
  for (const Dealt& dealt : dealt_) {
    for (std::uint32_t begin = dealt.run.begin; begin < dealt.run.end; begin += block_) {
      const PassRange block{begin, begin + block_};
      if (!taken_.overlaps(block)) taken_.add(block);
    }
  }
}

int Dealer::load(int rank) const {
  return static_cast<int>(std::ranges::count_if(
      dealt_, [rank](const Dealt& dealt) { return has(dealt.holders, rank); }));
}

}  // namespace lapidary::distributed
