#include <cmath>
#include <filesystem>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/load_scene.h"
#include "app/messages.h"
#include "image/image_io.h"
#include "image/output_file.h"
#include "render/bake.h"
#include "render/render.h"
#include "scene/build.h"

namespace lapidary::app {
namespace {

using Json = nlohmann::ordered_json;
using geometry::ChartEnd;
using transport::IlluminationMaps;
using transport::MappedSurface;
using transport::PhotonLight;

std::filesystem::path folder_of(const BakeCommand& command) {
  if (!command.folder.empty()) return command.folder;
  return std::filesystem::path(command.scene.file).stem().string() + "_maps";
}

/// The folder for the maps, made before the work to find out what would fail after it, and removed
/// again if that comes to nothing.
class OutputFolder {
 public:
  explicit OutputFolder(std::filesystem::path path) : path_(std::move(path)) {
    std::error_code error;
    is_new_ = std::filesystem::create_directories(path_, error);
    if (error || !std::filesystem::is_directory(path_, error)) {
      throw Error({}, fmt::format("the folder {} cannot be made", path_.string()),
                  "give another one with -o");
    }
    image::OutputFile probe(path_ / "index.json");
  }
  ~OutputFolder() {
    std::error_code ignored;  // it stays if there is anything in it
    if (is_new_) std::filesystem::remove(path_, ignored);
  }
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool is_new_ = false;
};

PhotonLight photon_light(BakeCommand::Light light) {
  switch (light) {
    case BakeCommand::Light::indirect:
      return PhotonLight::indirect;
    case BakeCommand::Light::caustics:
      return PhotonLight::caustics;
    case BakeCommand::Light::all:
      break;
  }
  return PhotonLight::all;
}

std::string_view name_of(PhotonLight light) {
  return light == PhotonLight::all        ? "all"
         : light == PhotonLight::indirect ? "indirect"
                                          : "caustics";
}

std::string_view extension_of(BakeCommand::Format format) {
  return format == BakeCommand::Format::exr   ? "exr"
         : format == BakeCommand::Format::png ? "png"
                                              : "hdr";
}

[[noreturn]] void fail_without_maps(IlluminationMaps::State state, PhotonLight light) {
  if (state == IlluminationMaps::State::no_light) {
    throw Error({}, "there is nothing to bake: no light sends out anything",
                "add a light, or give one of the lights some power");
  }
  throw Error({},
              fmt::format("there is nothing to bake: no photon of {} light fell on a surface that "
                          "scatters widely",
                          name_of(light)),
              light == PhotonLight::all
                  ? "mirrors and glass hold no light, and nothing leaves an opaque body"
                  : "--light all also bakes what comes straight from the lights");
}

Json json_of(Vec2d v) {
  return {v.x, v.y};
}
Json json_of(Vec3d v) {
  return {v.x, v.y, v.z};
}

std::string_view name_of(ChartEnd end) {
  return end == ChartEnd::seam ? "seam" : end == ChartEnd::pole ? "pole" : "border";
}

/// World points of a chart at the nodes of a lattice over the image, row by row from low v; null
/// where there is no surface. Of a flat chart two a side say all.
Json lattice_of(const MappedSurface& surface, const render::BakedImage& baked, int side) {
  Json points = Json::array();
  for (int k = 0; k < side * side; ++k) {
    const double x = static_cast<double>(k % side) / (side - 1);
    const double y = static_cast<double>(k / side) / (side - 1);
    const auto p = surface.point_at(baked.chart, {std::lerp(baked.min.x, baked.max.x, x),
                                                  std::lerp(baked.min.y, baked.max.y, y)});
    points.push_back(p ? json_of(*p) : Json());
  }
  return {{"columns", side}, {"rows", side}, {"points", points}};
}

/// What a flat chart's coordinates are in the world: origin + u du + v dv. By points of it that are
/// there, as the corners may not be.
std::optional<Json> plane_of(const MappedSurface& surface, const render::BakedImage& baked) {
  static constexpr std::string_view flat[] = {"rectangle", "disk", "box", "half_space",
                                              "polyhedron"};
  const bool is_cap = (baked.surface == "cylinder" || baked.surface == "cone") && baked.chart > 0;
  const bool is_flat = is_cap || std::ranges::find(flat, baked.surface) != std::end(flat);
  if (!is_flat) return {};
  const Vec2d middle = (baked.min + baked.max) * 0.5, step = (baked.max - baked.min) * 0.125;
  const auto p = surface.point_at(baked.chart, middle);
  const auto pu = surface.point_at(baked.chart, middle + Vec2d{step.x, 0});
  const auto pv = surface.point_at(baked.chart, middle + Vec2d{0, step.y});
  if (!p || !pu || !pv) return {};
  const Vec3d du = (*pu - *p) / step.x, dv = (*pv - *p) / step.y;
  return Json{{"kind", "plane"},
              {"origin", json_of(*p - du * middle.x - dv * middle.y)},
              {"du", json_of(du)},
              {"dv", json_of(dv)}};
}

Json mapping_of(const MappedSurface& surface, const render::BakedImage& baked,
                const std::string& mesh_file) {
  if (surface.mesh_charts()) {
    if (baked.atlas.empty()) return {{"kind", "own_uvs"}};
    Json mapping{{"kind", "atlas"}, {"mesh", mesh_file}};
    if (!baked.why_atlas.empty()) mapping["why_not_own_uvs"] = baked.why_atlas;
    return mapping;
  }
  if (auto plane = plane_of(surface, baked)) return *plane;
  constexpr int side = 33;
  return {{"kind", baked.surface}, {"lattice", lattice_of(surface, baked, side)}};
}

Json json_of(const MappedSurface& surface, const render::BakedImage& baked,
             const std::string& image_file, const std::string& mesh_file) {
  return {{"image", image_file},
          {"object", baked.object},
          {"surface", baked.surface},
          {"piece", baked.chart + 1},
          {"side", baked.side == transport::SurfaceSide::front ? "front" : "back"},
          {"size", {baked.image.width, baked.image.height}},
          {"photons", baked.photons},
          {"uv_min", json_of(baked.min)},
          {"uv_max", json_of(baked.max)},
          {"ends",
           {{"u", name_of(baked.ends.u)},
            {"v_low", name_of(baked.ends.v_low)},
            {"v_high", name_of(baked.ends.v_high)}}},
          {"mapping", mapping_of(surface, baked, mesh_file)}};
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  image::OutputFile file(path);
  file.write(text.data(), text.size());
  file.commit();
}

/// The images, meshes with an atlas, and the index of them all.
void write_maps(const BakeCommand& command, const std::filesystem::path& folder,
                const IlluminationMaps& maps, std::span<const render::BakedImage> images,
                const transport::IlluminationMaps::Settings& settings) {
  Json list = Json::array();
  image::WriteOptions options;
  options.display.tone = image::Tone::none;
  for (const render::BakedImage& baked : images) {
    const MappedSurface& surface = maps.surfaces()[baked.map_surface];
    const std::string file = fmt::format("{}.{}", baked.name, extension_of(command.format));
    const std::string mesh = baked.atlas.empty() ? "" : baked.name + ".obj";
    image::write_image(folder / file, baked.image, options);
    if (!mesh.empty()) write_text(folder / mesh, render::obj_with_atlas(surface, baked));
    list.push_back(json_of(surface, baked, file, mesh));
  }
  const Json index{
      {"software", "Lapidary " LAPIDARY_VERSION},
      {"scene", std::filesystem::path(command.scene.file).filename().string()},
      {"quantity", "irradiance"},
      {"unit", command.format == BakeCommand::Format::png ? "sRGB, 1 is 1 W/m2" : "W/m2"},
      {"color_space", "linear Rec. 709"},
      {"light", name_of(settings.budget.light)},
      {"photons", settings.budget.photons},
      {"seed", settings.budget.seed},
      {"filter", settings.filter == transport::BlurFilter::box ? "box" : "gaussian"},
      {"radius", maps.radius()},
      {"texel", maps.texel_size()},
      {"maps", list}};
  write_text(folder / "index.json", index.dump(1) + "\n");
}

}  // namespace

ExitCode run(const BakeCommand& command) {
  check_settings(command.settings);
  WarningLog warnings;
  ThreadPool pool(command.threads);
  auto description = load_scene(command.scene, command.settings, {warnings});
  complete_scene(command.scene, description);
  const OutputFolder folder(folder_of(command));
  const scene::Scene scene = scene::build(
      description, {description.render.size, pool, warnings, description.render.light_choice});
  print_warnings(warnings.take());

  auto settings = render::illumination_settings(description.render);
  settings.budget.light = photon_light(command.light);
  const IlluminationMaps maps(scene, settings, pool);
  if (maps.state() != IlluminationMaps::State::active) {
    fail_without_maps(maps.state(), settings.budget.light);
  }
  const std::vector<render::BakedImage> images = render::bake(scene, maps);
  write_maps(command, folder.path(), maps, images, settings);
  if (!command.is_quiet) {
    fmt::print(stderr, "{}: {} maps of {} photons, blurred by {:.3g}\n", folder.path().string(),
               images.size(), settings.budget.photons, maps.radius());
  }
  return ExitCode::done;
}

}  // namespace lapidary::app
