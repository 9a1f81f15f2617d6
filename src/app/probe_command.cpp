#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/load_scene.h"
#include "app/messages.h"
#include "app/ray_text.h"
#include "inspect/probe.h"

namespace lapidary::app {
namespace {

using Ray = ProbeCommand::Ray;

/// The rays of a file, one a line; lines without anything are passed over.
std::vector<Ray> read_rays(const std::string& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) {
    throw file_error(path, "cannot be read", "it is to hold rays, six numbers a line");
  }
  std::vector<Ray> rays;
  std::string text;
  for (int line = 1; std::getline(file, text); ++line) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    try {
      rays.push_back(parse_ray(text));
    } catch (const std::invalid_argument& problem) {
      constexpr std::size_t longest = 80;
      if (text.size() > longest) text = text.substr(0, longest) + "...";
      throw Error({.file = path, .line = line},
                  fmt::format("a line {}, not '{}'", problem.what(), text));
    }
  }
  if (file.bad()) throw file_error(path, "cannot be read");
  if (rays.empty()) throw file_error(path, "holds no rays", "a line is six numbers: 0 0 5 0 0 -1");
  return rays;
}

std::string to_json(const std::vector<inspect::ProbeHit>& hits) {
  auto list = nlohmann::ordered_json::array();
  for (const inspect::ProbeHit& hit : hits) {
    list.push_back({{"t", hit.t},
                    {"object", hit.object},
                    {"leaf", hit.leaf},
                    {"kind", hit.kind},
                    {"normal", {hit.normal.x, hit.normal.y, hit.normal.z}},
                    {"enter", hit.crossing == geometry::Crossing::enter},
                    {"medium_before", hit.medium_before},
                    {"medium_after", hit.medium_after}});
  }
  nlohmann::ordered_json json;
  json["hits"] = std::move(list);
  // A name may hold any bytes.
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace

ExitCode run(const ProbeCommand& command) {
  const std::vector<Ray> rays =
      command.ray ? std::vector{*command.ray} : read_rays(command.rays_file);
  WarningLog warnings;
  const auto description = load_scene(command.scene, {}, {warnings});
  const inspect::Probe probe(description);
  for (const Ray& ray : rays) fmt::print("{}\n", to_json(probe.along(ray.origin, ray.direction)));
  print_warnings(warnings.take());
  return ExitCode::done;
}

}  // namespace lapidary::app
