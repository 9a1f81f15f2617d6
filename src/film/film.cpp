#include "film/film.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>

namespace lapidary::film {
namespace {

/// Adds `count` values to consecutive sums; a sample with any fault is counted once per value.
template <typename... Values>
void add_values(const FixedScale& scale, std::int64_t* sums, SampleFaults& faults,
                Values... values) {
  const auto add_one = [&](double value) {
    const auto [units, outcome] = scale.fixed(value);
    *sums = saturating_add(*sums, units);
    ++sums;
    if (outcome == FixedScale::Outcome::not_finite) ++faults.not_finite;
    if (outcome == FixedScale::Outcome::saturated) ++faults.saturated;
  };
  (add_one(static_cast<double>(values)), ...);
}

Rgb to_rgb(double r, double g, double b) {
  return {static_cast<float>(r), static_cast<float>(g), static_cast<float>(b)};
}

template <typename Number, typename Sum>
void add_all(std::vector<Number>& to, const std::vector<Number>& from, const Sum& sum) {
  std::transform(to.begin(), to.end(), from.begin(), to.begin(), sum);
}

Film::State empty_state(const Film::Settings& settings) {
  Film::State state;
  state.settings = settings;
  const std::size_t pixels = settings.pixels();
  state.sums.assign(pixels * settings.channels(), 0);
  state.squares.assign(pixels * 3, 0);
  state.samples.assign(pixels, 0);
  if (settings.layers == Layers::all) {
    state.objects.assign(pixels, 0);
    state.hits.assign(pixels, 0);
  }
  return state;
}

}  // namespace

std::uint64_t Film::bytes(const Settings& settings) {
  const std::uint64_t pixels = settings.pixels();
  // Sums, squares and numbers of samples, objects and hits; then floats for the channels and for
  // encoding them.
  constexpr std::uint64_t squares = 3 * sizeof(std::int64_t) + sizeof(std::uint32_t);
  if (settings.layers == Layers::beauty) return pixels * (24 + squares + 3 * sizeof(float) * 2);
  return pixels * (PixelSums::channels * 8 + squares + 8 + 14 * sizeof(float) * 2);
}

Film::Film(State state)
    : state_(std::move(state)),
      channels_(settings().channels()),
      beauty_scale_(1.0 / settings().exposure_factor),
      depth_scale_(settings().scene_size),
      // Finer than 2^-32 of the sums' unit would overflow for bright pixels, coarser would lose
      // the dark ones; squares beyond the range saturate.
      square_scale_(1.0 / (16.0 * settings().exposure_factor * settings().exposure_factor)) {
  assert(state_.sums.size() == settings().pixels() * channels_);
}

Film::Film(const Settings& settings) : Film(empty_state(settings)) {}

void Film::add(const PixelSample& sample, PixelSums& sums, SampleFaults& faults) const {
  if (sums.samples_ == 0) sums.object_ = sample.object;
  ++sums.samples_;
  std::int64_t* s = sums.sums_.data();
  add_values(beauty_scale_, s, faults, sample.beauty.r, sample.beauty.g, sample.beauty.b);
  if (layers() == Layers::beauty) return;
  add_values(unit_scale_, s + PixelSums::albedo, faults, sample.albedo.r, sample.albedo.g,
             sample.albedo.b, sample.normal.x, sample.normal.y, sample.normal.z);
  add_values(depth_scale_, s + PixelSums::depth, faults, sample.depth);
  if (sample.object != 0) ++sums.hits_;
}

void Film::add_block(const PassRange& passes, int x, int y, const PixelSums& block) {
  const std::size_t p = pixel(x, y);
  for (std::size_t c = 0; c < channels_; ++c) {
    std::int64_t& sum = state_.sums[p * channels_ + c];
    sum = saturating_add(sum, block.sums_[c]);
  }
  state_.samples[p] += block.samples_;
  const double n = block.samples_;
  for (std::size_t c = 0; c < 3; ++c) {
    const double total = beauty_scale_.value(block.sums_[PixelSums::beauty + c]);
    std::int64_t& square = state_.squares[p * 3 + c];
    square = saturating_add(square, square_scale_.fixed(total * total / n).units);
  }
  if (layers() == Layers::beauty) return;
  state_.hits[p] += block.hits_;
  if (is_first(passes.begin)) state_.objects[p] = block.object_;
}

void Film::finish_block(const PassRange& passes, const SampleFaults& faults) {
  state_.passes.add(passes);
  state_.faults += faults;
  ++state_.blocks;
}

void Film::add(const Film& other) {
  const State& from = other.state_;
  assert(from.settings == settings() && !from.passes.overlaps(state_.passes));
  if (from.passes.is_empty()) return;
  add_all(state_.sums, from.sums, saturating_add);
  add_all(state_.squares, from.squares, saturating_add);
  add_all(state_.samples, from.samples, std::plus<>());
  add_all(state_.hits, from.hits, std::plus<>());
  if (is_first(from.passes.begin())) state_.objects = from.objects;
  state_.passes.add(from.passes);
  state_.blocks += from.blocks;
  state_.faults += from.faults;
}

double Film::mean(std::size_t p, std::size_t channel) const {
  const FixedScale& scale = channel < PixelSums::albedo  ? beauty_scale_
                            : channel < PixelSums::depth ? unit_scale_
                                                         : depth_scale_;
  return state_.samples[p] == 0 ? 0.0
                                : scale.value(state_.sums[p * channels_ + channel]) /
                                      static_cast<double>(state_.samples[p]);
}

Rgb Film::beauty(int x, int y) const {
  const std::size_t p = pixel(x, y);
  return to_rgb(mean(p, 0), mean(p, 1), mean(p, 2));
}

Rgb Film::albedo(int x, int y) const {
  const std::size_t p = pixel(x, y), c = PixelSums::albedo;
  return to_rgb(mean(p, c), mean(p, c + 1), mean(p, c + 2));
}

Vec3f Film::normal(int x, int y) const {
  const std::size_t p = pixel(x, y), c = PixelSums::normal;
  return Vec3f(Vec3d{mean(p, c), mean(p, c + 1), mean(p, c + 2)});
}

float Film::depth(int x, int y) const {
  const std::size_t p = pixel(x, y);
  if (state_.hits[p] == 0) return 0.0f;
  const double sum = depth_scale_.value(state_.sums[p * channels_ + PixelSums::depth]);
  return static_cast<float>(sum / state_.hits[p]);
}

std::uint32_t Film::object(int x, int y) const {
  return state_.objects[pixel(x, y)];
}

Rgb Film::variance(int x, int y) const {
  if (state_.blocks < 2) return {};
  const std::size_t p = pixel(x, y);
  const auto channel = [&](std::size_t c) {
    const double m = mean(p, c);
    const double second =
        square_scale_.value(state_.squares[p * 3 + c]) / static_cast<double>(state_.samples[p]);
    return std::max(0.0, second - m * m) / static_cast<double>(state_.blocks - 1);
  };
  return to_rgb(channel(0), channel(1), channel(2));
}

}  // namespace lapidary::film
