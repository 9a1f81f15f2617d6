#include "app/preparation.h"

#include "app/load_scene.h"
#include "app/phase_clock.h"
#include "inspect/averted_lights.h"
#include "inspect/solid_warnings.h"
#include "scene/build.h"

namespace lapidary::app {
namespace {

film::Film::Settings film_settings(const description::SceneDescription& description,
                                   const scene::Scene& scene, film::Layers layers) {
  const film::Film::Settings settings{.width = description.render.size.width,
                                      .height = description.render.size.height,
                                      .layers = layers,
                                      .exposure_factor = description.film.exposure,
                                      .scene_size = scene.size()};
  render::check_memory(settings);
  return settings;
}

void warn_about_caustics(transport::Caustics::State state, WarningLog& warnings) {
  if (state != transport::Caustics::State::nothing_arrives) return;
  warnings.add({},
               "no photon that was sent through glass or off a mirror reached a surface that could "
               "show it: what caustics there are is left to paths");
}

void warn_about_maps(const transport::IlluminationMaps* maps, WarningLog& warnings) {
  using State = transport::IlluminationMaps::State;
  // Of lights that send out nothing the scene has warned.
  if (maps == nullptr || maps->state() != State::nothing_arrives) return;
  warnings.add({},
               "no photon fell on a surface that can hold an illumination map after it was "
               "scattered: only direct light is seen");
}

}  // namespace

Preparation::Preparation(const RenderCommand& command, film::Layers layers, const Workshop& with) {
  PhaseClock clock;
  with.display.begin(Phase::load, command.scene.frame);
  description_ =
      load_scene(command.scene, command.settings, {with.warnings, &with.files, &with.kept.files});
  complete_scene(command.scene, description_);
  const description::RenderSettings& settings = description_.render;
  render::check_size(settings.size);
  seconds_.load = clock.lap();

  with.display.begin(Phase::build, command.scene.frame);
  scene_.emplace(
      scene::build(description_, {settings.size, with.pool, with.warnings, settings.light_choice,
                                  &with.files, &with.kept.scene}));
  inspect::warn_about_averted_lights(description_, with.warnings);
  inspect::warn_about_empty_solids(description_, *scene_, with.warnings);
  inspect::warn_about_buried_camera(description_, *scene_, with.warnings);
  seconds_.build = clock.lap();

  film_ = film_settings(description_, *scene_, layers);
}

void warn_about_photons(const render::BlockRenderer& renderer, WarningLog& warnings) {
  warn_about_caustics(renderer.caustics().state(), warnings);
  warn_about_maps(renderer.illumination(), warnings);
}

}  // namespace lapidary::app
