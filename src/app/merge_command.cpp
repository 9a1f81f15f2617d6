#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "app/commands.h"
#include "app/different_picture.h"
#include "app/messages.h"
#include "app/outputs.h"
#include "render/checkpoint.h"

namespace lapidary::app {
namespace {

using render::Canvas;
using render::Checkpoint;

/// "samples 1 to 16 and 33 to 48".
std::string text_of(const film::PassSet& passes) {
  std::string text;
  for (const film::PassRange& range : passes.ranges()) {
    const bool is_last = range == passes.ranges().back();
    text += fmt::format("{}{} to {}",
                        text.empty() ? "samples "
                        : is_last    ? " and "
                                     : ", ",
                        range.begin + 1, range.end);
  }
  return text;
}

/// Decisions about the samples of the same epochs.
bool agree(const render::SamplePlan& a, const render::SamplePlan& b) {
  const auto& as = a.epochs();
  const auto& bs = b.epochs();
  const auto both = static_cast<std::ptrdiff_t>(std::min(as.size(), bs.size()));
  return a.photons() == b.photons() && std::equal(as.begin(), as.begin() + both, bs.begin());
}

/// Puts parts together, one after the other.
class Merging {
 public:
  void add(const std::string& file) {
    Checkpoint part = render::read_checkpoint(file);
    if (part.origin.version != LAPIDARY_VERSION) {
      throw DifferentPicture(
          fmt::format("{}: the part is of another version of Lapidary", file),
          {fmt::format("Lapidary {}, now {}", part.origin.version, LAPIDARY_VERSION)},
          "merge with the version that rendered it");
    }
    if (!whole_) {
      whole_.emplace(part.origin,
                     Canvas(film::Film(part.canvas.film().settings()), part.canvas.plan()));
    }
    check_same(file, part);
    for (const auto& [other, passes] : parts_) {
      if (!passes.overlaps(part.canvas.film().passes())) continue;
      throw file_error(file,
                       fmt::format("has {}, and {} has {}: some of them twice",
                                   text_of(part.canvas.film().passes()), other, text_of(passes)),
                       "leave out one of the two");
    }
    parts_.emplace_back(file, part.canvas.film().passes());
    if (part.canvas.plan()) whole_->canvas.learn(*part.canvas.plan());
    whole_->canvas.add(part.canvas.film());
  }

  Checkpoint finish(WarningLog& warnings) {
    Canvas& canvas = whole_->canvas;
    canvas.settle();
    const film::PassSet& passes = canvas.film().passes();
    if (passes.is_empty()) throw Error({}, "there are no samples in any of the parts");
    const film::PassSet missing = passes.gaps_before(passes.end());
    if (!missing.is_empty()) {
      warnings.add({}, fmt::format("{} of each pixel are missing; render --resume adds them",
                                   text_of(missing)));
    }
    const std::uint64_t end = canvas.samples_knowable_until();
    if (end <= std::numeric_limits<std::uint32_t>::max()) {
      warnings.add({}, fmt::format("adaptive sampling can go on with this up to {} samples per "
                                   "pixel and no further",
                                   end));
    }
    return std::move(*whole_);
  }

 private:
  void check_same(const std::string& file, const Checkpoint& part) const {
    auto differences = render::differences(whole_->origin, part.origin);
    const film::Film::Settings &ours = whole_->canvas.film().settings(),
                               &theirs = part.canvas.film().settings();
    if (ours.layers != theirs.layers) {
      differences.emplace_back("layers: those of an OpenEXR file, in one of both");
    }
    const auto &our_plan = whole_->canvas.plan(), &their_plan = part.canvas.plan();
    if (our_plan.has_value() != their_plan.has_value() ||
        (our_plan && !agree(*our_plan, *their_plan))) {
      differences.emplace_back("adaptive sampling: decided otherwise");
    }
    if (differences.empty() && ours != theirs) {
      differences.emplace_back("the size of the scene");
    }
    if (differences.empty()) return;
    throw DifferentPicture(
        fmt::format("{}: this is a part of another picture than {}", file, parts_.front().first),
        differences, "parts of one picture are rendered from one scene, with the same settings");
  }

  std::optional<Checkpoint> whole_;
  std::vector<std::pair<std::string, film::PassSet>> parts_;
};

}  // namespace

ExitCode run(const MergeCommand& command) {
  const Outputs outputs(command.outputs, Outputs::Checkpoints::kept);
  outputs.check();
  Merging merging;
  for (const std::string& part : command.parts) merging.add(part);
  WarningLog warnings;
  const Checkpoint whole = merging.finish(warnings);
  print_warnings(warnings.take());
  outputs.write(whole.canvas, {whole.origin, 0.0}, Outputs::Completion::complete);
  for (const std::string& picture : outputs.pictures()) {
    fmt::print(stderr, "{}: {}x{}, {} samples per pixel of {} parts\n", picture,
               whole.canvas.film().width(), whole.canvas.film().height(),
               whole.canvas.film().pass_count(), command.parts.size());
  }
  return ExitCode::done;
}

}  // namespace lapidary::app
