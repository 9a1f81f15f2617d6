#pragma once

#include "distributed/channel.h"
#include "film/film.h"
#include "render/block.h"
#include "render/sample_plan.h"

namespace lapidary::distributed {

/// Passes of one epoch that were rendered by themselves.
struct RenderedRun {
  film::PassRange run;  ///< as it was asked for; the film may have fewer of its passes
  film::Film film;
  render::BlockTally tally;
  double block_seconds = 0;  ///< that a block took, of wall time; 0 if there is none
};

/// As a message. What is the same for all blocks of a picture is left out.
Message film_message(const RenderedRun& rendered);
/// Throws Error for bytes that are no film of these settings.
RenderedRun read_film_message(const Bytes& bytes, const film::Film::Settings& settings);

/// Passes, without a film.
Message pass_message(Topic topic, const film::PassRange& passes);
film::PassRange read_pass_message(const Bytes& bytes);

/// A decision of adaptive sampling, and the number of its epoch.
struct Decision {
  std::uint64_t epoch = 0;
  render::Allocation allocation;
};
Message epoch_message(const Decision& decision);
/// `pixels` of the picture. Throws Error for bytes that are no decision about them.
Decision read_epoch_message(const Bytes& bytes, std::size_t pixels);

}  // namespace lapidary::distributed
