#include "app/progress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "app/terminal.h"

namespace lapidary::app {
namespace {

std::string format_rate(double samples_per_second) {
  return samples_per_second >= 1e6 ? fmt::format("{:.2f} M samples/s", samples_per_second * 1e-6)
                                   : fmt::format("{:.0f} k samples/s", samples_per_second * 1e-3);
}

std::string format_photons(std::uint64_t photons) {
  const auto count = static_cast<double>(photons);
  return count >= 1e6 ? fmt::format("{:.3g} M photons", count * 1e-6)
                      : fmt::format("{:.0f} k photons", count * 1e-3);
}

/// What stands beside a bar, most important first.
std::vector<std::string> facts(const ProgressState& state) {
  std::vector<std::string> all;
  if (state.frame) all.push_back(fmt::format("frame {}", *state.frame));
  all.push_back(fmt::format("{:.0f} %", std::floor(100 * state.fraction)));
  if (state.seconds_left) all.push_back(format_duration(*state.seconds_left) + " left");
  if (state.noise) all.push_back(fmt::format("noise {:.3g}", *state.noise));
  all.push_back(fmt::format("{} samples per pixel", state.samples));
  all.push_back(format_rate(state.samples_per_second));
  if (state.photons > 0) all.push_back(format_photons(state.photons));
  return all;
}

std::string_view name_of(Phase phase) {
  constexpr std::array<std::string_view, 5> names = {"load", "build", "photons", "render", "write"};
  return names[static_cast<std::size_t>(phase)];
}

std::string_view description_of(Phase phase) {
  constexpr std::array<std::string_view, 5> descriptions = {"reading the scene",
                                                            "building the scene", "preparing light",
                                                            "rendering", "writing the picture"};
  return descriptions[static_cast<std::size_t>(phase)];
}

/// Redraws one line in place.
class BarDisplay : public ProgressDisplay {
 public:
  ~BarDisplay() override { fmt::print(stderr, "\r\x1b[K"); }
  void begin(Phase phase, std::optional<int> frame) override {
    const std::string prefix = frame ? fmt::format("frame {}: ", *frame) : "";
    const std::string line = fmt::format("{}{} ...", prefix, description_of(phase));
    fmt::print(stderr, "\r{:.{}}\x1b[K", line, std::max(terminal_.width() - 1, 0));
    std::fflush(stderr);
  }
  void update(const ProgressState& state) override {
    fmt::print(stderr, "\r{}\x1b[K", bar_line(state, terminal_.width() - 1));
    std::fflush(stderr);
  }
  void finish() override {
    fmt::print(stderr, "\r\x1b[K");
    std::fflush(stderr);
  }

 private:
  Terminal terminal_{stderr};
};

/// A line for each tenth of the way, and one after ten seconds without any.
class LineDisplay : public ProgressDisplay {
 public:
  void begin(Phase, std::optional<int>) override {}
  void update(const ProgressState& state) override {
    const int tenth = static_cast<int>(10 * state.fraction);
    if (tenth <= last_tenth_ && state.seconds < last_seconds_ + 10) return;
    last_tenth_ = tenth;
    last_seconds_ = state.seconds;
    fmt::print(stderr, "{}\n", plain_line(state));
    std::fflush(stderr);
  }
  void finish() override {}

 private:
  int last_tenth_ = 0;
  double last_seconds_ = 0;
};

class JsonDisplay : public ProgressDisplay {
 public:
  void begin(Phase phase, std::optional<int> frame) override {
    nlohmann::ordered_json object = {{"event", "phase"}, {"phase", name_of(phase)}};
    if (frame) object["frame"] = *frame;
    fmt::print(stderr, "{}\n", object.dump());
    std::fflush(stderr);
  }
  void update(const ProgressState& state) override {
    fmt::print(stderr, "{}\n", json_line(state));
    std::fflush(stderr);
  }
  void finish() override {}
};

class NoDisplay : public ProgressDisplay {
 public:
  void begin(Phase, std::optional<int>) override {}
  void update(const ProgressState&) override {}
  void finish() override {}
};

}  // namespace

std::string format_duration(double seconds) {
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto whole = static_cast<long long>(std::llround(std::min(seconds, 3.6e8)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string bar_line(const ProgressState& state, int width) {
  constexpr int least_bar = 10;
  constexpr int most_bar = 40;
  std::string beside;
  for (const std::string& fact : facts(state)) {
    const int length = static_cast<int>(beside.size() + 2 + fact.size());
    if (length + least_bar + 2 > width) break;
    beside += "  " + fact;
  }
  const int bar = std::clamp(width - 2 - static_cast<int>(beside.size()), 0, most_bar);
  const int filled = static_cast<int>(bar * std::clamp(state.fraction, 0.0, 1.0));
  if (bar == 0) return "";
  return fmt::format("[{}{}]{}", std::string(static_cast<std::size_t>(filled), '#'),
                     std::string(static_cast<std::size_t>(bar - filled), '.'), beside);
}

std::string plain_line(const ProgressState& state) {
  return fmt::format("{}", fmt::join(facts(state), ", "));
}

std::string json_line(const ProgressState& state) {
  nlohmann::ordered_json object = {{"event", "progress"},
                                   {"fraction", state.fraction},
                                   {"samples_per_pixel", state.samples},
                                   {"seconds", state.seconds},
                                   {"samples_per_second", state.samples_per_second}};
  if (state.seconds_left) object["seconds_left"] = *state.seconds_left;
  if (state.noise) object["noise"] = *state.noise;
  if (state.photons > 0) object["photons"] = state.photons;
  if (state.frame) object["frame"] = *state.frame;
  return object.dump();
}

std::unique_ptr<ProgressDisplay> make_progress_display(ProgressStyle style) {
  if (style == ProgressStyle::automatic) {
    style = Terminal(stderr).is_interactive() ? ProgressStyle::bar : ProgressStyle::lines;
  }
  switch (style) {
    case ProgressStyle::bar:
      return std::make_unique<BarDisplay>();
    case ProgressStyle::lines:
      return std::make_unique<LineDisplay>();
    case ProgressStyle::json:
      return std::make_unique<JsonDisplay>();
    case ProgressStyle::automatic:
    case ProgressStyle::none:
      break;
  }
  return std::make_unique<NoDisplay>();
}

}  // namespace lapidary::app
