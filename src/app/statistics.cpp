#include "app/statistics.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "app/progress.h"

namespace lapidary::app {
namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

rusage usage_of_process() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage;
}

nlohmann::ordered_json to_json(const transport::Counters& counters) {
  return {{"emitted", counters.photons_emitted},
          {"traced", counters.photons_traced},
          {"left", counters.photons_left}};
}

nlohmann::ordered_json to_json(const transport::IlluminationMaps& maps) {
  std::uint64_t texels = 0, bytes = 0;
  for (const transport::IlluminationMaps::Entry& entry : maps.entries()) {
    texels += entry.map.grid().size();
    bytes += entry.map.bytes();
  }
  nlohmann::ordered_json json = to_json(maps.counters());
  json.update({{"maps", maps.entries().size()}, {"texels", texels}, {"bytes", bytes}});
  return json;
}

/// As a word.
const char* ending_of(const RunStatistics& statistics) {
  return statistics.render.ending == render::Ending::interrupted ? "interrupted" : "complete";
}

}  // namespace

double process_cpu_seconds() {
  const rusage usage = usage_of_process();
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

std::string summary_line(const std::string& picture, const RunStatistics& s) {
  std::string line =
      fmt::format("{}: {}x{}, {} samples per pixel, {}", picture, s.size.width, s.size.height,
                  s.samples_per_pixel, format_duration(s.seconds.render));
  if (std::isfinite(s.render.noise)) line += fmt::format(", noise {:.3g}", s.render.noise);
  if (s.render.ending == render::Ending::interrupted) line += ", interrupted";
  return line;
}

std::string json_line(const std::string& picture, const RunStatistics& s) {
  nlohmann::ordered_json json = {{"event", "picture"},
                                 {"file", picture},
                                 {"ended", ending_of(s)},
                                 {"size", {s.size.width, s.size.height}},
                                 {"samples_per_pixel", s.samples_per_pixel},
                                 {"seconds", s.seconds.render}};
  if (std::isfinite(s.render.noise)) json["noise"] = s.render.noise;
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void RunStatistics::note(const Preparation& preparation) {
  scene = preparation.scene().counts();
  size = preparation.description().render.size;
  seconds.load = preparation.seconds().load;
  seconds.build = preparation.seconds().build;
}

std::string to_json(const RunStatistics& s, const transport::IlluminationMaps* maps) {
  const long peak_kibibytes = usage_of_process().ru_maxrss;
  const render::BlockTally& tally = s.render.tally;
  nlohmann::ordered_json json = {
      {"version", LAPIDARY_VERSION},
      {"ended", ending_of(s)},
      {"scene",
       {{"objects", s.scene.objects},
        {"operands", s.scene.operands},
        {"triangles", s.scene.triangles},
        {"lights", s.scene.lights}}},
      {"size", {s.size.width, s.size.height}},
      {"seconds",
       {{"load", s.seconds.load},
        {"build", s.seconds.build},
        {"photons", s.seconds.photons},
        {"render", s.seconds.render},
        {"write", s.seconds.write}}},
      {"cpu_seconds", process_cpu_seconds()},
      {"render_cpu_seconds", s.render_cpu_seconds},
      {"samples_per_pixel", s.samples_per_pixel},
      {"samples_before", s.samples_before},
      {"checkpoints", {{"written", s.checkpoints.count}, {"seconds", s.checkpoints.seconds}}},
      {"samples", tally.samples},
      {"rays", tally.counters.nearest_queries + tally.counters.occlusion_queries},
      {"photons", to_json(tally.counters)},
      {"map_photons", nullptr},
      {"peak_rss_bytes", static_cast<std::uint64_t>(peak_kibibytes) * 1024},
      {"ranks", s.ranks},
      {"threads", s.threads},
      {"nan_samples", tally.faults.not_finite},
      {"saturated_samples", tally.faults.saturated},
      {"noise", nullptr}};
  json["photons"]["bytes"] = tally.photon_bytes;
  if (maps != nullptr) json["map_photons"] = to_json(*maps);
  if (std::isfinite(s.render.noise)) json["noise"] = s.render.noise;
  return json.dump(2) + "\n";
}

}  // namespace lapidary::app
