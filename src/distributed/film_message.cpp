#include "distributed/film_message.h"

#include <algorithm>
#include <utility>

#include "distributed/packed_numbers.h"

namespace lapidary::distributed {
namespace {

using film::Film;
using film::PassRange;

void add(const PassRange& passes, ByteWriter& to) {
  to.add(passes.begin);
  to.add(passes.end);
}

PassRange take_passes(ByteReader& from) {
  PassRange passes;
  passes.begin = from.take<std::uint32_t>();
  passes.end = from.take<std::uint32_t>();
  if (passes.begin > passes.end) ByteReader::fail();
  return passes;
}

void add(const render::BlockTally& tally, ByteWriter& to) {
  const transport::Counters& c = tally.counters;
  for (const std::uint64_t number :
       {c.nearest_queries, c.occlusion_queries, c.photons_emitted, c.photons_traced, c.photons_left,
        tally.faults.not_finite, tally.faults.saturated, tally.samples, tally.photon_bytes}) {
    to.add(number);
  }
}

render::BlockTally take_tally(ByteReader& from) {
  render::BlockTally tally;
  transport::Counters& c = tally.counters;
  for (std::uint64_t* number : {&c.nearest_queries, &c.occlusion_queries, &c.photons_emitted,
                                &c.photons_traced, &c.photons_left, &tally.faults.not_finite,
                                &tally.faults.saturated, &tally.samples, &tally.photon_bytes}) {
    *number = from.take<std::uint64_t>();
  }
  return tally;
}

void add_sums(const Film::State& state, ByteWriter& to) {
  pack(state.sums, state.settings.channels(), to);
  pack(state.squares, 3, to);
  pack(state.samples, 1, to);
  pack(state.objects, 1, to);
  pack(state.hits, 1, to);
}

void take_sums(Film::State& state, ByteReader& from) {
  unpack(state.sums, state.settings.channels(), from);
  unpack(state.squares, 3, from);
  unpack(state.samples, 1, from);
  unpack(state.objects, 1, from);
  unpack(state.hits, 1, from);
}

}  // namespace

Message film_message(const RenderedRun& rendered) {
  const Film::State& state = rendered.film.state();
  ByteWriter writer;
  add(rendered.run, writer);
  add(rendered.tally, writer);
  writer.add(rendered.block_seconds);
  const bool is_empty = state.passes.is_empty();
  add(is_empty ? PassRange() : PassRange{state.passes.begin(), state.passes.end()}, writer);
  writer.add(state.blocks);
  if (!is_empty) add_sums(state, writer);
  return std::move(writer).message(Topic::film);
}

RenderedRun read_film_message(const Bytes& bytes, const Film::Settings& settings) {
  ByteReader reader(bytes);
  const PassRange run = take_passes(reader);
  const render::BlockTally tally = take_tally(reader);
  const auto block_seconds = reader.take<double>();
  Film::State state = Film(settings).take_state();
  const PassRange passes = take_passes(reader);
  const bool is_inside = passes.is_empty() || (passes.begin >= run.begin && passes.end <= run.end);
  if (!is_inside) ByteReader::fail();
  state.passes.add(passes);
  state.blocks = reader.take<std::uint64_t>();
  state.faults = tally.faults;
  if (!passes.is_empty()) take_sums(state, reader);
  if (!reader.rest().empty()) ByteReader::fail();
  return {run, Film(std::move(state)), tally, block_seconds};
}

Message pass_message(Topic topic, const PassRange& passes) {
  ByteWriter writer;
  add(passes, writer);
  return std::move(writer).message(topic);
}

PassRange read_pass_message(const Bytes& bytes) {
  ByteReader reader(bytes);
  const PassRange passes = take_passes(reader);
  if (!reader.rest().empty()) ByteReader::fail();
  return passes;
}

Message epoch_message(const Decision& decision) {
  const auto& counts = decision.allocation.counts;
  ByteWriter writer;
  writer.add(decision.epoch);
  writer.add(decision.allocation.photons);
  // Two in a byte: they are from 1 to 16.
  for (std::size_t i = 0; i < counts.size(); i += 2) {
    const int high = i + 1 < counts.size() ? counts[i + 1] - 1 : 0;
    writer.add(static_cast<std::uint8_t>(high << 4 | (counts[i] - 1)));
  }
  return std::move(writer).message(Topic::epoch);
}

Decision read_epoch_message(const Bytes& bytes, std::size_t pixels) {
  ByteReader reader(bytes);
  Decision decision;
  decision.epoch = reader.take<std::uint64_t>();
  decision.allocation.photons = reader.take<double>();
  const auto packed = reader.take((pixels + 1) / 2);
  if (!reader.rest().empty()) ByteReader::fail();
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto both = std::to_integer<unsigned>(packed[i / 2]);
    const unsigned count = (i % 2 == 0 ? both : both >> 4) & 15u;
    decision.allocation.counts.push_back(static_cast<std::uint8_t>(count + 1));
  }
  return decision;
}

}  // namespace lapidary::distributed
