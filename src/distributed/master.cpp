#include "distributed/master.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/memory.h"
#include "distributed/byte_stream.h"
#include "distributed/dealer.h"
#include "render/pace.h"

namespace lapidary::distributed {
namespace {

using Clock = std::chrono::steady_clock;
using film::PassRange;
using render::Canvas;
using render::Control;
using render::Ending;
using render::StopRules;

constexpr std::uint64_t without_end = std::numeric_limits<std::uint64_t>::max();

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A mean in which what is long ago counts less and less.
class RunningMean {
 public:
  void add(double value) { mean_ = mean_ == 0.0 ? value : 0.875 * mean_ + 0.125 * value; }
  double value() const { return mean_; }

 private:
  double mean_ = 0;
};

class Master {
 public:
  Master(Crew& crew, const Equipment& equipment, const StopRules& rules, const Control& control,
         Canvas& canvas)
      : crew_(crew),
        channel_(crew.channel()),
        equipment_(equipment),
        rules_(rules),
        control_(control),
        canvas_(canvas),
        block_(render::passes_per_block(equipment.settings.width, equipment.settings.height)),
        pace_(rules, canvas),
        dealer_(crew.ranks(), block_, canvas.film().passes()),
        thread_(equipment) {}

  render::Statistics render();

 private:
  bool is_stopped() const {
    return control_.stop != nullptr && *control_.stop && !canvas_.film().passes().is_empty();
  }
  bool is_time_over() const { return rules_.seconds && pace_.limit_is_met(); }
  bool is_done() const {
    if (pace_.ending() == Ending::complete) return true;
    return in_order_.empty() && dealer_.done().first_missing(pace_.first_pass()) >= whole_end();
  }
  /// Where the blocks end that are to be rendered and whole.
  std::uint64_t whole_end() const {
    const auto last = pace_.last_pass();
    return std::min(time_end_, last ? *last / block_ * block_ : without_end);
  }

  enum class Outcome { rendered, stopped };
  Outcome render_blocks();
  Outcome finish();
  void render_cut();
  std::uint64_t films_that_fit() const;
  std::uint32_t blocks_in(double seconds) const;
  Dealer::Bounds bounds() const;
  void deal();
  void give(int rank, const PassRange& run);
  bool receive();
  void handle(const Received& received);
  void accept(int from, RenderedRun rendered);
  void add(RenderedRun rendered);
  void announce_decisions();

  Crew& crew_;
  Channel& channel_;
  Equipment equipment_;
  const StopRules& rules_;
  const Control& control_;
  Canvas& canvas_;
  std::uint32_t block_;
  render::Pace pace_;
  Dealer dealer_;
  std::optional<RunThread> thread_;
  render::BlockTally tally_;
  RunningMean block_seconds_, film_seconds_;
  std::map<std::uint32_t, RenderedRun> in_order_;  ///< those that wait for their turn
  /// Where it ends because the time is over; behind it nobody has begun anything.
  std::uint64_t time_end_ = without_end;
  std::uint64_t announced_ = 0;  ///< decisions
  int idle_ = 0;                 ///< others that have finished
  Clock::time_point last_progress_ = Clock::now() - std::chrono::hours(1);
};

/// In a quarter of the memory: those that wait for their turn are kept one by one.
std::uint64_t Master::films_that_fit() const {
  const std::uint64_t film = film::Film::bytes(equipment_.settings);
  return std::max<std::uint64_t>(1, physical_memory_bytes() / 4 / film);
}

std::uint32_t Master::blocks_in(double seconds) const {
  return static_cast<std::uint32_t>(std::clamp(seconds / block_seconds_.value(), 1.0, 1e6));
}

Dealer::Bounds Master::bounds() const {
  constexpr double least = 0.05;             // seconds of a run: messages take a millisecond or two
  constexpr double share = 0.1;              // of its time that rank 0 receives and adds films
  constexpr std::uint64_t blocks_ahead = 4;  // of each rank, while the noise decides
  const auto ranks = static_cast<std::uint32_t>(channel_.ranks());
  Dealer::Bounds bounds{.begin = pace_.first_pass(),
                        .end = std::min(whole_end(), canvas_.samples_known_until()),
                        .end_of_work = whole_end()};
  bounds.epochs = canvas_.plan() ? Dealer::Bounds::Epochs::are_ends : Dealer::Bounds::Epochs::none;
  constexpr std::uint64_t last = std::numeric_limits<std::uint32_t>::max();
  bounds.end = std::min(bounds.end, last / block_ * block_);
  if (rules_.noise) {
    const std::uint64_t next = canvas_.film().passes().first_missing(bounds.begin);
    const std::uint64_t window = std::min(blocks_ahead * ranks, films_that_fit());
    bounds.end = std::min(bounds.end, next + window * block_);
  } else if (block_seconds_.value() > 0.0) {
    // Of runs as long as this there are as many as rank 0 can take.
    const double seconds = ranks * film_seconds_.value();
    bounds.least_blocks = blocks_in(seconds);
    bounds.most_blocks = blocks_in(std::max(least, seconds / share));
  }
  return bounds;
}

void Master::give(int rank, const PassRange& run) {
  if (rank == 0) {
    thread_->add(run);
  } else {
    channel_.send(rank, pass_message(Topic::run, run));
  }
}

void Master::deal() {
  constexpr int enough = 2;  // one that runs and one ahead, so that nobody waits for a message
  const Clock::time_point now = Clock::now();
  const Dealer::Bounds limits = bounds();
  for (int load = 0; load < enough; ++load) {
    for (int rank = 0; rank < channel_.ranks(); ++rank) {
      if (dealer_.load(rank) > load) continue;
      const auto run = dealer_.deal(rank, limits, now);
      if (run) give(rank, *run);
    }
  }
  for (int rank = 0; rank < channel_.ranks(); ++rank) {
    if (dealer_.load(rank) > 0) continue;
    const auto shared = dealer_.share(rank, block_seconds_.value(), now);
    if (!shared) continue;
    give(rank, shared->run);
    if (shared->means == Dealer::Shared::Means::beside_it) continue;
    if (shared->from == 0) {
      thread_->drop(shared->run);
    } else {
      channel_.send(shared->from, pass_message(Topic::drop, shared->run));
    }
  }
}

bool Master::receive() {
  bool is_news = false;
  while (const auto received = channel_.poll()) {
    handle(*received);
    is_news = true;
  }
  while (auto rendered = thread_->take()) {
    accept(0, std::move(*rendered));
    is_news = true;
  }
  return is_news;
}

void Master::handle(const Received& received) {
  const Clock::time_point begin = Clock::now();
  const Bytes& bytes = *received.message.bytes;
  switch (received.message.topic) {
    case Topic::film:
      accept(received.from, read_film_message(bytes, equipment_.settings));
      film_seconds_.add(received.seconds + seconds_since(begin));
      return;
    case Topic::idle:
      ++idle_;
      return;
    case Topic::failed:
      throw Error({}, fmt::format("rank {}: {}", received.from, ByteReader(bytes).take_text()));
    default:
      ByteReader::fail();
  }
}

void Master::accept(int from, RenderedRun rendered) {
  const auto others = dealer_.done(from, rendered.run, rendered.film.passes());
  if (!others) return;
  for (const int rank : *others) {
    if (rank == 0) {
      thread_->drop(rendered.run);
    } else {
      channel_.send(rank, pass_message(Topic::drop, rendered.run));
    }
  }
  block_seconds_.add(rendered.block_seconds);
  if (!rules_.noise) {
    add(std::move(rendered));
  } else {
    in_order_.emplace(rendered.run.begin, std::move(rendered));
    const auto is_next = [&] {
      const std::uint32_t next = canvas_.film().passes().first_missing(pace_.first_pass());
      return !in_order_.empty() && in_order_.begin()->first == next;
    };
    while (is_next() && pace_.ending() != Ending::complete)
      add(std::move(in_order_.extract(in_order_.begin()).mapped()));
  }
}

void Master::add(RenderedRun rendered) {
  tally_ += rendered.tally;
  canvas_.add(std::move(rendered.film));
  // Without the passes before the part nothing can be decided, and nothing has to wait for it.
  if (canvas_.film().passes().first_missing() < pace_.first_pass()) canvas_.settle();
  pace_.block_done(rendered.tally, rendered.block_seconds);
  announce_decisions();
  if (is_done()) return;
  if (control_.on_block) control_.on_block(canvas_);
  constexpr double often = 0.1;  // seconds: looking at the noise takes a moment
  if (!control_.on_progress || seconds_since(last_progress_) < often) return;
  control_.on_progress(pace_.progress());
  last_progress_ = Clock::now();
}

void Master::announce_decisions() {
  if (!canvas_.plan()) return;
  const auto& epochs = canvas_.plan()->epochs();
  for (; announced_ < epochs.size(); ++announced_) {
    const Decision decision{announced_, epochs[announced_]};
    send_on(channel_, epoch_message(decision));
    thread_->learn(decision);
  }
}

Master::Outcome Master::render_blocks() {
  announce_decisions();
  while (!is_done()) {
    if (is_stopped()) return Outcome::stopped;
    if (is_time_over() && time_end_ == without_end && finish() == Outcome::stopped) {
      return Outcome::stopped;
    }
    deal();
    if (!receive()) nap(channel_);
  }
  return Outcome::rendered;
}

/// All end after the block that they are at. What is missing below the last of these is rendered
/// as well: the picture is one that the number of its samples determines.
Master::Outcome Master::finish() {
  send_on(channel_, {Topic::finish});
  thread_->finish();
  while (idle_ < channel_.ranks() - 1 || !thread_->is_idle()) {
    if (is_stopped()) return Outcome::stopped;
    if (!receive()) nap(channel_);
  }
  dealer_.recall();
  time_end_ = dealer_.done().end();
  return Outcome::rendered;
}

/// What is asked for beyond the last whole block: less than one.
void Master::render_cut() {
  const PassRange next = pace_.next_passes();
  if (next.is_empty() || pace_.is_of_whole_blocks(next)) return;
  const double begin = pace_.seconds();
  const render::BlockTally tally = canvas_.render_cut(equipment_.renderer, next, equipment_.pool);
  tally_ += tally;
  pace_.block_done(tally, pace_.seconds() - begin);
}

render::Statistics Master::render() {
  const Outcome outcome = render_blocks();
  crew_.dismiss();
  thread_.reset();
  if (outcome == Outcome::rendered) render_cut();
  if (control_.on_progress) control_.on_progress(pace_.progress());
  return {outcome == Outcome::stopped ? Ending::interrupted : pace_.ending(), pace_.seconds(),
          tally_, pace_.noise()};
}

}  // namespace

render::Statistics render(Crew& crew, const Equipment& equipment, const StopRules& rules,
                          const Control& control, Canvas& canvas) {
  return Master(crew, equipment, rules, control, canvas).render();
}

}  // namespace lapidary::distributed
