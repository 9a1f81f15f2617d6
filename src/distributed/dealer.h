#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "film/pass_set.h"

namespace lapidary::distributed {

/// Decides which rank renders which passes: whole blocks, lowest first, and so few at a time that
/// all come to the end together. Who has nothing to do gets what others have not begun, or are far
/// too long about: a slow rank, or a dead one, holds nobody up. Films of the same passes are the
/// same, so nothing is lost but work when one is rendered twice.
class Dealer {
 public:
  using Clock = std::chrono::steady_clock;

  /// `block` passes are a block. Passes of `done` need not be rendered.
  Dealer(int ranks, std::uint32_t block, film::PassSet done);

  /// What may be dealt now.
  struct Bounds {
    std::uint32_t begin = 0;
    std::uint64_t end = 0;           ///< a multiple of the block
    std::uint64_t end_of_work = 0;   ///< beyond it nothing will ever be dealt
    std::uint32_t least_blocks = 1;  ///< in one run, where there are so many
    std::uint32_t most_blocks = 1;
    enum class Epochs { are_ends, none } epochs = Epochs::none;  ///< whether runs end there
  };

  /// The next run for a rank, which then has it; nothing if all within the bounds is dealt.
  std::optional<film::PassRange> deal(int rank, const Bounds& bounds, Clock::time_point now);

  /// A run that another rank has, for one that has none: this one has it now as well.
  struct Shared {
    film::PassRange run;
    int from = 0;
    enum class Means { instead_of_it, beside_it } means = Means::beside_it;
  };
  /// `block_seconds` is what a block takes on the average.
  std::optional<Shared> share(int rank, double block_seconds, Clock::time_point now);

  /// Passes have been rendered by a rank, which was asked for `run`. Returns who else has that, and
  /// no longer does; nothing if some of the passes are known already: then they are
  /// worth nothing, and the others of `run` are to be dealt again.
  std::optional<std::vector<int>> done(int rank, const film::PassRange& run,
                                       const film::PassSet& passes);

  /// Nobody has anything any more: what is not done is to be dealt again.
  void recall();

  /// Runs that a rank has.
  int load(int rank) const;
  const film::PassSet& done() const { return done_; }

 private:
  struct Dealt {
    film::PassRange run;
    std::vector<int> holders;  ///< in the order in which they got it
    Clock::time_point since;
  };
  bool is_first_of(int rank, const Dealt& dealt) const;
  void find_taken();

  int ranks_;
  std::uint32_t block_;
  film::PassSet done_;
  film::PassSet taken_;  ///< done or dealt
  std::vector<Dealt> dealt_;
};

}  // namespace lapidary::distributed
