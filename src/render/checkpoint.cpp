#include "render/checkpoint.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "render/render.h"

namespace lapidary::render {
namespace {

using film::Film;
using film::Layers;
using image::Attachment;
using image::LayeredImage;

constexpr double format = 1;
/// Epochs whose counts share a channel.
constexpr std::size_t epochs_per_channel = 8;

/// The names of a film's sums, in their order.
constexpr std::array<const char*, film::PixelSums::channels> sum_names = {
    "R",        "G",        "B",        "albedo.R", "albedo.G",
    "albedo.B", "normal.X", "normal.Y", "normal.Z", "depth.Z"};

/// A number in the fewest digits that read back as the same.
std::string exact(double x) {
  return fmt::format("{}", x);
}

/// Both halves of the `index`-th of `per_pixel` 64-bit numbers.
void add_halves(Attachment& attachment, const std::string& name,
                const std::vector<std::int64_t>& numbers, std::size_t per_pixel,
                std::size_t index) {
  const auto width = static_cast<std::size_t>(attachment.width);
  for (const auto& [half, shift] : {std::pair{".hi", 32}, {".lo", 0}}) {
    attachment.channels.push_back(
        {name + half, [=, &numbers, by = shift](int y, std::span<std::uint32_t> row) {
           const std::int64_t* first = &numbers[static_cast<std::size_t>(y) * width * per_pixel];
           for (std::size_t x = 0; x < width; ++x) {
             const auto bits = static_cast<std::uint64_t>(first[x * per_pixel + index]);
             row[x] = static_cast<std::uint32_t>(bits >> by);
           }
         }});
  }
}

void add_numbers(Attachment& attachment, const std::string& name,
                 const std::vector<std::uint32_t>& numbers) {
  const auto width = static_cast<std::size_t>(attachment.width);
  attachment.channels.push_back({name, [&numbers, width](int y, std::span<std::uint32_t> row) {
                                   const auto* first =
                                       &numbers[static_cast<std::size_t>(y) * width];
                                   std::copy_n(first, width, row.begin());
                                 }});
}

void add_counts(Attachment& attachment, const std::vector<Allocation>& epochs) {
  const auto width = static_cast<std::size_t>(attachment.width);
  for (std::size_t first = 0; first < epochs.size(); first += epochs_per_channel) {
    const std::size_t end = std::min(first + epochs_per_channel, epochs.size());
    attachment.channels.push_back(
        {fmt::format("counts.{}", first / epochs_per_channel),
         [&epochs, first, end, width](int y, std::span<std::uint32_t> row) {
           std::ranges::fill(row, 0u);
           for (std::size_t e = first; e < end; ++e) {
             const std::uint8_t* counts = &epochs[e].counts[static_cast<std::size_t>(y) * width];
             const std::size_t shift = 4 * (e - first);
             for (std::size_t x = 0; x < width; ++x) row[x] |= (counts[x] - 1u) << shift;
           }
         }});
  }
}

std::vector<double> photons_of(const std::vector<Allocation>& epochs) {
  std::vector<double> photons;
  for (const Allocation& epoch : epochs) photons.push_back(epoch.photons);
  return photons;
}

image::Metadata metadata_of(const Origin& origin, const Canvas& canvas) {
  const Film& film = canvas.film();
  image::Metadata metadata = {
      {"checkpoint", format},
      {"lapidary", origin.version},
      {"scene", origin.scene},
      {"settings", to_lines(origin.settings)},
      {"parameters", to_lines(origin.parameters)},
      {"files", to_lines(origin.files)},
      {"passes", to_text(film.passes())},
      {"layers", std::string(film.layers() == Layers::all ? "all" : "beauty")},
      {"exposure_factor", exact(film.settings().exposure_factor)},
      {"scene_size", exact(film.settings().scene_size)},
      {"not_finite", std::to_string(film.faults().not_finite)},
      {"saturated", std::to_string(film.faults().saturated)}};
  if (!canvas.plan()) return metadata;
  const SamplePlan& plan = *canvas.plan();
  metadata.push_back({"photon_cost", exact(plan.photons().cost)});
  metadata.push_back({"photon_error", exact(plan.photons().error)});
  metadata.push_back({"epochs", fmt::format("{}", fmt::join(photons_of(plan.epochs()), " "))});
  return metadata;
}

/// Reads the parts of a checkpoint; whatever is missing or impossible is an Error.
class Reading {
 public:
  Reading(std::string file, LayeredImage part) : file_(std::move(file)), part_(std::move(part)) {}

  Checkpoint read() {
    check_format();
    Origin origin{text("lapidary"), text("scene"), parse_lines(text("settings")),
                  parse_lines(text("parameters")), parse_file_lines(text("files"))};
    Film::State state = Film(film_settings()).take_state();
    const auto passes = film::parse_pass_set(text("passes"));
    const std::uint32_t block = passes_per_block(part_.width, part_.height);
    if (!passes || !is_of_whole_blocks(*passes, part_.width, part_.height)) fail("passes");
    state.passes = *passes;
    state.blocks = passes->count() / block;
    state.faults = {number<std::uint64_t>("not_finite"), number<std::uint64_t>("saturated")};
    take_sums(state);
    check_counts(state);
    std::optional<SamplePlan> plan = read_plan();
    return {std::move(origin), Canvas(Film(std::move(state)), std::move(plan))};
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw file_error(file_,
                     fmt::format("its checkpoint is broken: '{}' is missing or makes no "
                                 "sense",
                                 what),
                     "take an older copy, or render it again");
  }

  const image::Attribute* find(const std::string& name) const {
    const auto found = std::ranges::find(part_.metadata, name, &image::Attribute::name);
    return found == part_.metadata.end() ? nullptr : &*found;
  }

  void check_format() const {
    const image::Attribute* attribute = find("checkpoint");
    const double* stated = attribute ? std::get_if<double>(&attribute->value) : nullptr;
    if (stated == nullptr) fail("checkpoint");
    if (*stated == format) return;
    throw file_error(file_,
                     fmt::format("its checkpoint is of format {}, made by Lapidary {}; this is "
                                 "Lapidary {}, which reads format {}",
                                 *stated, text("lapidary"), LAPIDARY_VERSION, format),
                     "go on with the version that it is from, or start again");
  }

  const std::string& text(const std::string& name) const {
    const image::Attribute* attribute = find(name);
    const auto* value = attribute ? std::get_if<std::string>(&attribute->value) : nullptr;
    if (value == nullptr) fail(name);
    return *value;
  }

  template <typename Number>
  Number number_in(const std::string& name, std::string_view stated) const {
    Number value{};
    const char* end = stated.data() + stated.size();
    const auto [stop, problem] = std::from_chars(stated.data(), end, value);
    if (problem != std::errc() || stop != end) fail(name);
    return value;
  }
  template <typename Number>
  Number number(const std::string& name) const {
    return number_in<Number>(name, text(name));
  }
  double positive(const std::string& name) const {
    const auto value = number<double>(name);
    if (!(value > 0.0) || !std::isfinite(value)) fail(name);
    return value;
  }

  Film::Settings film_settings() const {
    const std::string& layers = text("layers");
    if (layers != "all" && layers != "beauty") fail("layers");
    const Film::Settings settings{.width = part_.width,
                                  .height = part_.height,
                                  .layers = layers == "all" ? Layers::all : Layers::beauty,
                                  .exposure_factor = positive("exposure_factor"),
                                  .scene_size = positive("scene_size")};
    check_memory(settings);
    return settings;
  }

  /// The samples of a channel, which are given up: a film is large enough without a copy of it.
  std::vector<std::uint32_t> take(const std::string& name) {
    const auto found = std::ranges::find(part_.channels, name, &image::Channel::name);
    if (found == part_.channels.end()) fail(name);
    auto* samples = std::get_if<std::vector<std::uint32_t>>(&found->samples);
    if (samples == nullptr) fail(name);
    return std::move(*samples);
  }

  void take_halves(const std::string& name, std::vector<std::int64_t>& numbers,
                   std::size_t per_pixel, std::size_t index) {
    const std::vector<std::uint32_t> high = take(name + ".hi"), low = take(name + ".lo");
    for (std::size_t p = 0; p < high.size(); ++p) {
      numbers[p * per_pixel + index] =
          static_cast<std::int64_t>(std::uint64_t{high[p]} << 32 | low[p]);
    }
  }

  void take_sums(Film::State& state) {
    const std::size_t channels = state.settings.channels();
    for (std::size_t c = 0; c < channels; ++c) {
      take_halves(std::string("sum.") + sum_names[c], state.sums, channels, c);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      take_halves(std::string("square.") + sum_names[c], state.squares, 3, c);
    }
    state.samples = take("samples");
    if (state.settings.layers == Layers::beauty) return;
    state.objects = take("object");
    state.hits = take("hits");
  }

  /// Every pixel took part in every pass.
  void check_counts(const Film::State& state) const {
    const std::uint64_t least = state.passes.count(), most = Allocation::most * least;
    const bool are_possible = std::ranges::all_of(
        state.samples, [&](std::uint64_t samples) { return samples >= least && samples <= most; });
    if (!are_possible) fail("samples");
    for (std::size_t i = 0; i < state.hits.size(); ++i) {
      if (state.hits[i] > state.samples[i]) fail("hits");
    }
  }

  std::optional<SamplePlan> read_plan() {
    if (find("photon_cost") == nullptr) return std::nullopt;
    const PhotonShare share{number<double>("photon_cost"), number<double>("photon_error")};
    if (!(share.cost >= 0.0 && share.error >= 0.0 && share.error <= 1.0)) fail("photon_error");
    std::vector<Allocation> epochs;
    for (std::string_view rest = text("epochs"); !rest.empty();) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      const auto photons = number_in<double>("epochs", rest.substr(0, end));
      if (!(photons >= 1.0 && photons <= 1e3)) fail("epochs");
      epochs.push_back({{}, photons});
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (epochs.size() == 1 || epochs.size() > SamplePlan::most_epochs) fail("epochs");
    take_allocations(epochs);
    return SamplePlan(share, part_.width, part_.height, std::move(epochs));
  }

  void take_allocations(std::vector<Allocation>& epochs) {
    for (std::size_t first = 0; first < epochs.size(); first += epochs_per_channel) {
      const std::vector<std::uint32_t> counts =
          take(fmt::format("counts.{}", first / epochs_per_channel));
      const std::size_t end = std::min(first + epochs_per_channel, epochs.size());
      for (std::size_t e = first; e < end; ++e) {
        epochs[e].counts.reserve(counts.size());
        for (const std::uint32_t packed : counts) {
          const std::uint32_t count = packed >> 4 * (e - first) & 15u;
          epochs[e].counts.push_back(static_cast<std::uint8_t>(count + 1));
        }
      }
    }
  }

  std::string file_;
  LayeredImage part_;
};

}  // namespace

Attachment checkpoint_of(const Origin& origin, const Canvas& canvas) {
  const Film::State& state = canvas.film().state();
  Attachment attachment{.name = std::string(checkpoint_part),
                        .width = state.settings.width,
                        .height = state.settings.height};
  const std::size_t channels = state.settings.channels();
  for (std::size_t c = 0; c < channels; ++c) {
    add_halves(attachment, std::string("sum.") + sum_names[c], state.sums, channels, c);
  }
  for (std::size_t c = 0; c < 3; ++c) {
    add_halves(attachment, std::string("square.") + sum_names[c], state.squares, 3, c);
  }
  add_numbers(attachment, "samples", state.samples);
  if (state.settings.layers == Layers::all) {
    add_numbers(attachment, "object", state.objects);
    add_numbers(attachment, "hits", state.hits);
  }
  if (canvas.plan()) add_counts(attachment, canvas.plan()->epochs());
  attachment.metadata = metadata_of(origin, canvas);
  return attachment;
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
  std::optional<LayeredImage> part = image::read_part(path, std::string(checkpoint_part));
  if (!part) {
    throw file_error(path.string(), "holds no checkpoint to go on from",
                     "it was written by another program, an older version, or with --checkpoint 0");
  }
  return Reading(path.string(), std::move(*part)).read();
}

}  // namespace lapidary::render
