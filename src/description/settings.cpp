#include "description/settings.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "description/nodes.h"
#include "description/settings_readers.h"
#include "schema/literal.h"

namespace lapidary::schema {

using description::Caustics;
using description::FilterKind;
using description::IlluminationFilter;
using description::Integrator;
using description::LightChoice;
using description::PhotonAim;
using description::PictureSize;
using description::Sampling;
using description::ToneCurve;

template <>
struct EnumNames<ToneCurve> {
  static constexpr std::array<std::pair<std::string_view, ToneCurve>, 2> names{
      {{"filmic", ToneCurve::filmic}, {"none", ToneCurve::none}}};
};

template <>
struct EnumNames<Integrator> {
  static constexpr std::array<std::pair<std::string_view, Integrator>, 3> names{
      {{"path", Integrator::path},
       {"direct", Integrator::direct},
       {"illumination", Integrator::illumination}}};
};

template <>
struct EnumNames<IlluminationFilter> {
  static constexpr std::array<std::pair<std::string_view, IlluminationFilter>, 2> names{
      {{"gaussian", IlluminationFilter::gaussian}, {"box", IlluminationFilter::box}}};
};

template <>
struct EnumNames<LightChoice> {
  static constexpr std::array<std::pair<std::string_view, LightChoice>, 2> names{
      {{"tree", LightChoice::tree}, {"power", LightChoice::power}}};
};

template <>
struct EnumNames<PhotonAim> {
  static constexpr std::array<std::pair<std::string_view, PhotonAim>, 2> names{
      {{"learned", PhotonAim::learned}, {"none", PhotonAim::none}}};
};

template <>
struct EnumNames<Sampling> {
  static constexpr std::array<std::pair<std::string_view, Sampling>, 2> names{
      {{"adaptive", Sampling::adaptive}, {"uniform", Sampling::uniform}}};
};

template <>
struct EnumNames<Caustics> {
  static constexpr std::array<std::pair<std::string_view, Caustics>, 4> names{
      {{"auto", Caustics::automatic},
       {"photons", Caustics::photons},
       {"paths", Caustics::paths},
       {"off", Caustics::off}}};
};

template <>
struct EnumNames<FilterKind> {
  static constexpr std::array<std::pair<std::string_view, FilterKind>, 4> names{
      {{"box", FilterKind::box},
       {"tent", FilterKind::tent},
       {"gaussian", FilterKind::gaussian},
       {"blackman_harris", FilterKind::blackman_harris}}};
};

namespace {

/// Both sides of "960x540".
std::optional<std::pair<double, double>> parse_sides(std::string_view text) {
  const char* end = text.data() + text.size();
  int width = 0, height = 0;
  const auto first = std::from_chars(text.data(), end, width);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != 'x') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, height);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return std::pair<double, double>{width, height};
}

}  // namespace

template <>
struct Reader<PictureSize> {
  static std::string type() { return "{width, height} or \"960x540\""; }
  static PictureSize read(const Value& value, const Context& context) {
    Value width, height;
    if (value.kind() == ValueKind::string) {
      if (const auto sides = parse_sides(value.string())) {
        width = Value(sides->first), height = Value(sides->second);
      }
    } else if (value.kind() == ValueKind::table && value.table().items.size() == 2 &&
               value.table().fields.empty()) {
      width = value.table().items[0], height = value.table().items[1];
    }
    if (width.is_nil()) fail_type("{width, height} or \"960x540\"", value, context);
    return {Reader<int>::read(width, context.at("width")),
            Reader<int>::read(height, context.at("height"))};
  }
  static std::string text(const PictureSize& size) {
    return fmt::format("{{{}, {}}}", size.width, size.height);
  }
};

}  // namespace lapidary::schema

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::Unit;
using schema::Value;

Declaration<RenderSettings> declare_render() {
  using R = RenderSettings;
  constexpr auto open = schema::Range::End::open;
  Declaration<R> d({.name = "render",
                    .doc = "What to render and when to stop: at the first of samples, time and "
                           "noise that is reached.",
                    .section = "scene",
                    .examples = {"render = { size = { 960, 540 }, samples = 256, max_depth = 12 }",
                                 "render = { size = { 960, 540 }, noise = 0.02, time = 60 }"}});
  d.parameter(
       "size", &R::size,
       {.doc = "The picture's sides.", .unit = Unit::pixels, .range = {.min = 1, .max = 65536}})
      .parameter("samples", &R::samples,
                 {.doc = "Samples of each pixel, at least; 256 when nothing says when to stop.",
                  .range = {.min = 1, .max = 1 << 24}})
      .parameter("time", &R::time,
                 {.doc = "Wall time to spend.", .unit = Unit::seconds, .range = schema::positive})
      .parameter(
          "noise", &R::noise,
          {.doc = "Relative error to reach.", .range = {.min = 0, .max = 1, .min_end = open}})
      .parameter("integrator", &R::integrator,
                 {.doc = "\"path\" follows all light; \"direct\" is quick, without "
                         "interreflection; \"illumination\" is quick, with all of it blurred in "
                         "maps of photons on the surfaces."})
      .parameter("max_depth", &R::max_depth,
                 {.doc = "Most scattering events of a path.", .range = {.min = 1, .max = 65535}})
      .parameter("caustics", &R::caustics,
                 {.doc = "Who renders light focused by glass and mirrors: \"photons\", \"paths\" "
                         "from the camera by chance, \"auto\" each where it is better; "
                         "\"off\" leaves it out."})
      .parameter("photon_radius", [](R& r) -> double& { return r.photons.radius; },
                 {.doc = "How far around a point photons of caustics count in the first pass; ever "
                         "less in later ones. For studies: what converges fastest is the default.",
                  .unit = Unit::pixels,
                  .range = {.min = 0.01, .max = 1000}})
      .parameter(
          "photon_aim", [](R& r) -> PhotonAim& { return r.photons.aim; },
          {.doc = "\"learned\" sends photons of caustics where they are worth most; \"none\" "
                  "wherever lights shine, to compare."})
      .parameter(
          "sampling", &R::sampling,
          {.doc = "\"adaptive\": pixels that are noisy after 8 samples get up to 16 times as "
                  "many as the others; \"uniform\": all get the same."})
      .parameter("light_choice", &R::light_choice,
                 {.doc = "What the light for a point is chosen by: \"tree\" looks at where the "
                         "lights are and which way they shine, \"power\" does not."})
      .parameter("map_photons", [](R& r) -> int& { return r.illumination.photons; },
                 {.doc = "Photons for illumination maps.", .range = {.min = 1, .max = 1e9}})
      .parameter("map_radius", [](R& r) -> std::optional<double>& { return r.illumination.radius; },
                 {.doc = "How far illumination maps are blurred; by how densely photons fell when "
                         "left out.",
                  .unit = Unit::length,
                  .range = schema::positive})
      .parameter("map_filter", [](R& r) -> IlluminationFilter& { return r.illumination.filter; },
                 {.doc = "\"gaussian\" blurs illumination maps to circles, \"box\" to crosses."})
      .parameter("map_resolution",
                 [](R& r) -> std::optional<double>& { return r.illumination.resolution; },
                 {.doc = "Texels of illumination maps per scene unit; by the radius when left out.",
                  .range = schema::positive})
      .parameter("filter", [](R& r) -> FilterKind& { return r.filter.kind; },
                 {.doc = "How samples spread over pixels."})
      .parameter("filter_radius", [](R& r) -> std::optional<double>& { return r.filter.radius; },
                 {.doc = "How far; the filter's own when left out.",
                  .unit = Unit::pixels,
                  .range = {.min = 0.5, .max = 8}})
      .parameter("seed", &R::seed,
                 {.doc = "Another seed gives other noise.", .range = {.min = 0, .max = 0x1p53}});
  return d;
}

Declaration<FilmSettings> declare_film() {
  Declaration<FilmSettings> d({.name = "film",
                               .doc = "How measured light becomes a picture.",
                               .section = "scene",
                               .examples = {"film = { exposure = 1.5, tone = \"none\" }"}});
  d.parameter("exposure", &FilmSettings::exposure,
              {.doc = "Multiplies the light.", .range = {.min = 1e-12, .max = 1e12}})
      .parameter("tone", &FilmSettings::tone,
                 {.doc = "Curve of 8-bit pictures; linear files ignore it."});
  return d;
}

}  // namespace

const Declaration<RenderSettings>& render_declaration() {
  static const auto declaration = declare_render();
  return declaration;
}

const Declaration<FilmSettings>& film_declaration() {
  static const auto declaration = declare_film();
  return declaration;
}

std::vector<schema::NodeKind> settings_kinds() {
  return {table_kind(render_declaration()), table_kind(film_declaration())};
}

namespace {

template <typename Settings>
void apply(const Declaration<Settings>& declaration, Settings& settings, std::string_view key,
           std::string_view value) {
  schema::ValueArena arena;
  const auto flag = std::make_shared<const std::string>(fmt::format("--render {}={}", key, value));
  const schema::Call call{declaration.info().name, schema::CallSite(flag, 0)};
  const Value parsed = schema::parse_literal(value, arena).value_or(Value(value));
  declaration.set(settings, key, parsed, Context(call));
}

}  // namespace

void apply_render_override(RenderSettings& settings, std::string_view key, std::string_view value) {
  apply(render_declaration(), settings, key, value);
}

void apply_override(RenderSettings& render, FilmSettings& film, std::string_view key,
                    std::string_view value) {
  const auto& film_keys = film_declaration().info().parameters;
  const auto has_key = [key](const schema::ParameterInfo& p) { return p.name == key; };
  if (std::any_of(film_keys.begin(), film_keys.end(), has_key)) {
    apply(film_declaration(), film, key, value);
  } else {
    apply(render_declaration(), render, key, value);
  }
}

std::vector<std::pair<std::string, std::string>> setting_texts(const RenderSettings& render,
                                                               const FilmSettings& film) {
  auto texts = render_declaration().texts(render);
  for (auto& text : film_declaration().texts(film)) texts.push_back(std::move(text));
  return texts;
}

}  // namespace lapidary::description
