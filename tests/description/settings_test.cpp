#include "description/settings.h"

#include <gmock/gmock.h>

#include "construct.h"

namespace lapidary::description {
namespace {

using testing::HasSubstr;

TEST(RenderOverride, SetsEveryKey) {
  RenderSettings r;
  apply_render_override(r, "size", "960x540");
  EXPECT_EQ(r.size, (PictureSize{960, 540}));
  apply_render_override(r, "size", "{64, 32}");
  EXPECT_EQ(r.size, (PictureSize{64, 32}));
  apply_render_override(r, "samples", "64");
  apply_render_override(r, "time", "2.5");
  apply_render_override(r, "noise", "0.01");
  apply_render_override(r, "integrator", "direct");
  apply_render_override(r, "max_depth", "3");
  apply_render_override(r, "caustics", "paths");
  apply_render_override(r, "filter", "gaussian");
  apply_render_override(r, "filter_radius", "1.5");
  apply_render_override(r, "seed", "9007199254740992");
  EXPECT_EQ(r.samples, 64);
  EXPECT_EQ(r.time, 2.5);
  EXPECT_EQ(r.noise, 0.01);
  EXPECT_EQ(r.integrator, Integrator::direct);
  EXPECT_EQ(r.max_depth, 3);
  EXPECT_EQ(r.filter.kind, FilterKind::gaussian);
  EXPECT_EQ(r.filter.radius, 1.5);
  EXPECT_EQ(r.seed, 9007199254740992u);
}

TEST(RenderOverride, ReachesTheFilmToo) {
  RenderSettings render;
  FilmSettings film;
  apply_override(render, film, "samples", "3");
  apply_override(render, film, "exposure", "2");
  apply_override(render, film, "tone", "none");
  EXPECT_EQ(render.samples, 3);
  EXPECT_EQ(film.exposure, 2);
  EXPECT_EQ(film.tone, ToneCurve::none);
}

TEST(RenderOverride, RefusesAsTheSceneDoes) {
  const auto error_of = [](std::string_view key, std::string_view value) {
    return Constructor::message_of([&] {
      RenderSettings settings;
      apply_render_override(settings, key, value);
    });
  };
  EXPECT_EQ(error_of("sampels", "64"),
            "--render sampels=64: unknown parameter 'sampels' of render (did you mean 'samples'?)");
  EXPECT_THAT(error_of("samples", "many"), HasSubstr("must be a number, not the string 'many'"));
  EXPECT_THAT(error_of("samples", "0"), HasSubstr("must be from 1 to"));
  EXPECT_THAT(error_of("samples", "1.5"), HasSubstr("must be a whole number"));
  EXPECT_THAT(error_of("size", "0x0"), HasSubstr("size.width of render must be from 1 to 65536"));
  EXPECT_THAT(error_of("size", "12"), HasSubstr("{width, height} or \"960x540\", not 12"));
  EXPECT_THAT(error_of("size", "1e9x2"), HasSubstr("{width, height}"));
  EXPECT_THAT(error_of("size", "99999999999999999999x2"), HasSubstr("{width, height}"));
  EXPECT_THAT(error_of("caustics", "photon"), HasSubstr("did you mean 'photons'?"));
  EXPECT_THAT(error_of("integrator", "pathh"), HasSubstr("did you mean 'path'?"));
  EXPECT_THAT(error_of("seed", "-1"), HasSubstr("must be from 0"));
}

// What is written down of settings is read back as the same.
TEST(SettingTexts, MakeTheSameSettings) {
  RenderSettings render;
  FilmSettings film;
  for (const auto& [key, value] :
       std::vector<std::pair<std::string, std::string>>{{"size", "960x540"},
                                                        {"samples", "64"},
                                                        {"noise", "0.1"},
                                                        {"caustics", "photons"},
                                                        {"sampling", "uniform"},
                                                        {"light_choice", "power"},
                                                        {"map_radius", "0.30000000000000004"},
                                                        {"filter", "tent"},
                                                        {"seed", "9007199254740991"},
                                                        {"exposure", "1.1"},
                                                        {"tone", "none"}}) {
    apply_override(render, film, key, value);
  }
  RenderSettings same;
  FilmSettings same_film;
  const auto texts = setting_texts(render, film);
  for (const auto& [key, text] : texts) {
    if (!text.empty()) apply_override(same, same_film, key, text);
  }
  EXPECT_EQ(setting_texts(same, same_film), texts);
  EXPECT_EQ(same.size, render.size);
  EXPECT_EQ(same.illumination.radius, 0.1 + 0.2);
  EXPECT_EQ(same.seed, 9007199254740991u);
  EXPECT_EQ(same.time, std::nullopt);
  EXPECT_EQ(same_film.exposure, 1.1);
  EXPECT_THAT(texts, testing::Contains(std::pair<std::string, std::string>("time", "")));
}

TEST(Settings, AreReadFromTheScene) {
  Constructor make;
  const auto scene = make.make<SceneDescription>(
      "scene", R"({render = {size = {96, 54}, samples = 8, filter = "box"},
                   film = {exposure = 2, tone = "none"}})");
  EXPECT_EQ(scene->render.size.width, 96);
  EXPECT_EQ(scene->render.samples, 8);
  EXPECT_EQ(scene->render.filter.kind, FilterKind::box);
  EXPECT_EQ(scene->film.exposure, 2);
  EXPECT_EQ(scene->film.tone, ToneCurve::none);
  EXPECT_EQ(make.error_of("scene", "{render = {samles = 8}}"),
            "scene.lua:7: unknown parameter 'samles' of render (did you mean 'samples'?)");
  EXPECT_THAT(make.error_of("scene", "{film = {exposure = 0}}"),
              HasSubstr("film.exposure of scene must be"));
}

}  // namespace
}  // namespace lapidary::description
