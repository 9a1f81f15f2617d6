#include "distributed/film_message.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "distributed/file_message.h"
#include "support/random.h"

namespace lapidary::test {
namespace {

using distributed::Bytes;
using distributed::RenderedRun;
using film::Film;
using film::PassRange;

Film noisy_film(const Film::Settings& settings, const PassRange& passes, Random& random) {
  Film::State state = Film(settings).take_state();
  const auto fill = [&](auto& numbers) {
    for (auto& x : numbers) {
      x = static_cast<std::remove_reference_t<decltype(x)>>(random.bits() >> random.index(40));
    }
  };
  fill(state.sums), fill(state.squares), fill(state.samples), fill(state.objects);
  fill(state.hits);
  state.passes.add(passes);
  state.blocks = passes.size() / 4;
  state.faults = {3, 4};
  return Film(std::move(state));
}

RenderedRun noisy_run(const Film::Settings& settings, Random& random) {
  RenderedRun run{{8, 32}, noisy_film(settings, {8, 20}, random), {}, 0.25};
  run.tally.counters = {1, 2, 3, 4, 5};
  run.tally.faults = {3, 4};
  run.tally.samples = 6;
  run.tally.photon_bytes = 7;
  return run;
}

TEST(FilmMessage, ComesBackWithAllBits) {
  Random random(1);
  for (const auto layers : {film::Layers::all, film::Layers::beauty}) {
    const Film::Settings settings{.width = 13, .height = 11, .layers = layers};
    const RenderedRun sent = noisy_run(settings, random);
    const RenderedRun got =
        distributed::read_film_message(*distributed::film_message(sent).bytes, settings);
    EXPECT_EQ(got.run, sent.run);
    EXPECT_EQ(got.film.state(), sent.film.state());
    EXPECT_EQ(got.block_seconds, 0.25);
    EXPECT_EQ(got.tally.samples, 6u);
    EXPECT_EQ(got.tally.photon_bytes, 7u);
    EXPECT_EQ(got.tally.faults, sent.tally.faults);
    EXPECT_EQ(got.tally.counters.nearest_queries, 1u);
    EXPECT_EQ(got.tally.counters.photons_left, 5u);
  }
}

TEST(FilmMessage, RefusesWhatIsNoFilmOfThePicture) {
  Random random(2);
  const Film::Settings settings{.width = 5, .height = 3, .layers = film::Layers::all};
  const Bytes whole = *distributed::film_message(noisy_run(settings, random)).bytes;
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes part(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW(distributed::read_film_message(part, settings), Error);
  }
  Film::Settings others = settings;
  others.height = 2;
  EXPECT_THROW(distributed::read_film_message(whole, others), Error);
  others.height = 400;
  EXPECT_THROW(distributed::read_film_message(whole, others), Error);
  RenderedRun elsewhere = noisy_run(settings, random);
  elsewhere.run = {12, 32};
  EXPECT_THROW(
      distributed::read_film_message(*distributed::film_message(elsewhere).bytes, settings), Error);
}

TEST(EpochMessage, ComesBack) {
  for (const std::size_t pixels : {1u, 6u, 7u}) {
    distributed::Decision sent{3, {{}, 1.41}};
    for (std::size_t i = 0; i < pixels; ++i) {
      sent.allocation.counts.push_back(static_cast<std::uint8_t>(i % 3 == 0 ? 16 : i + 1));
    }
    const Bytes bytes = *distributed::epoch_message(sent).bytes;
    const auto got = distributed::read_epoch_message(bytes, pixels);
    EXPECT_EQ(got.epoch, 3u);
    EXPECT_EQ(got.allocation, sent.allocation);
    EXPECT_THROW(distributed::read_epoch_message(bytes, pixels + 2), Error);
  }
}

TEST(FileMessage, ComesBack) {
  const FileAnswers sent = {
      {std::string("content\0a.png", 13), std::string("\0\1\2", 3)}, {"x", ""}, {"y", "z"}};
  const Bytes bytes = *distributed::file_message(sent).bytes;
  EXPECT_EQ(distributed::read_file_message(bytes), sent);
  EXPECT_EQ(distributed::read_file_message({}), FileAnswers());
  const Bytes part(bytes.begin(), bytes.end() - 1);
  EXPECT_THROW(distributed::read_file_message(part), Error);
}

}  // namespace
}  // namespace lapidary::test
