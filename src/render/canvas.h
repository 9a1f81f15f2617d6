#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "film/film.h"
#include "render/block.h"
#include "render/sample_plan.h"

namespace lapidary::render {

/// A picture in the making: the exact sums of the blocks so far, and the plan of the samples that
/// later ones take. Films of blocks may be added in any order, from any machine: sums, decisions
/// and pictures are the same.
///
/// A decision is taken from the passes [0, n) alone (SamplePlan). Films of later passes that arrive
/// before it are kept apart until then; `settle` gives up waiting.
class Canvas {
 public:
  /// Empty, for what `renderer` renders.
  Canvas(const film::Film::Settings& settings, const BlockRenderer& renderer);
  /// Goes on with a film of whole blocks; no plan: every pass takes one sample of each pixel.
  Canvas(film::Film film, std::optional<SamplePlan> plan);

  const film::Film& film() const { return film_; }
  const std::optional<SamplePlan>& plan() const { return plan_; }
  /// The picture so far: `film` with what there is of a block that was cut short.
  const film::Film& picture() const { return cut_ ? *cut_ : film_; }

  /// Passes [0, samples_known_until()) can be rendered now.
  std::uint64_t samples_known_until() const;
  /// The same for ever, if passes are added lowest first: less than all where the film has passes
  /// that a decision had to be taken without.
  std::uint64_t samples_knowable_until() const;

  /// Renders a whole block into the film, even if a decision still waits for passes before it, and
  /// then in vain. Preconditions: its samples are known, no pass of it is there.
  BlockTally render(const BlockRenderer& renderer, const PassRange& block, ThreadPool& pool,
                    const Watch& watch = {});
  /// Renders the beginning of a block, of which the picture is to have no more. The film stays as
  /// it is, so that going on gives the same bits as if there had been no end here.
  BlockTally render_cut(const BlockRenderer& renderer, const PassRange& passes, ThreadPool& pool,
                        const Watch& watch = {});

  /// Adds whole blocks that were rendered elsewhere, none of which is here.
  void add(film::Film blocks);
  /// Takes over decisions that were taken elsewhere, from the same passes. Precondition: they are
  /// the same as far as both plans go.
  void learn(const SamplePlan& plan);
  /// Takes what is kept apart into the film. Decisions that waited for it are never taken.
  void settle();

 private:
  const SampleMap& map(std::uint32_t pass);
  bool must_wait(const PassRange& passes) const;
  void take_decisions();

  film::Film film_;
  std::optional<SamplePlan> plan_;
  std::optional<film::Film> cut_;
  std::map<std::uint32_t, film::Film> waiting_;  ///< by the decision that each waits for
};

/// Whether the passes are those of whole blocks in a picture of this size.
bool is_of_whole_blocks(const film::PassSet& passes, int width, int height);

}  // namespace lapidary::render
