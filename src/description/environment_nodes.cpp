#include <cmath>

#include "description/color_readers.h"
#include "description/light_node.h"
#include "description/nodes.h"
#include "math/constants.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Unit;

struct EnvironmentParameters {
  std::optional<schema::InputFile> file;
  std::optional<Spectrum> color;
  double scale = 1;
  double rotate = 0;
};

NodeKind environment() {
  Declaration<EnvironmentParameters> d(
      {.name = "environment",
       .doc = "Light from all around: a picture, or one color.",
       .section = light_section,
       .examples = {"environment \"sky.hdr\"", "environment { color = { 0.3, 0.4, 0.6 } }"}});
  d.parameter("file", &EnvironmentParameters::file,
              {.doc = "A picture of everything around, twice as wide as high; its top is +z, its "
                      "middle +y.",
               .shorthand = schema::Shorthand::yes})
      .parameter<Optional<LightReader>>("color", &EnvironmentParameters::color,
                                        {.doc = "The radiance everywhere, instead of 'file'; 1 "
                                                "when both are left out.",
                                         .unit = Unit::radiance})
      .parameter("scale", &EnvironmentParameters::scale,
                 {.doc = "Multiplies the light.", .range = schema::non_negative})
      .parameter("rotate", &EnvironmentParameters::rotate,
                 {.doc = "Turns the picture about z.", .unit = Unit::degrees});
  return node_kind(std::move(d), [](EnvironmentParameters&& e, const Context& context) {
    if (e.file && e.color) context.fail("takes either 'file' or 'color', not both");
    if (e.file) return light_node(ImageEnvironment{e.file->path, e.scale, e.rotate}, context);
    const Spectrum color = e.color.value_or(Spectrum::illuminant({1, 1, 1}));
    return light_node(ConstantEnvironment{color.scaled(static_cast<float>(e.scale))}, context);
  });
}

/// A sky as people say where its sun is.
struct SkyParameters {
  std::optional<Vec3d> sun_direction;
  std::optional<double> elevation;
  double azimuth = 0;
  double turbidity = 2.5;
  double ground_albedo = 0.2;
  bool sun = true;
  double scale = 1;
};

constexpr double lowest_sun = -10;  // degrees; beyond, what the air still scatters is next to none

Vec3d to_sun(const SkyParameters& s, const Context& context) {
  if (s.sun_direction && s.elevation) {
    context.fail("takes either 'sun_direction' or 'elevation', not both");
  }
  if (!s.sun_direction) {
    const double up = radians(s.elevation.value_or(45)), around = radians(s.azimuth);
    return {std::cos(up) * std::sin(around), std::cos(up) * std::cos(around), std::sin(up)};
  }
  const Vec3d d = *s.sun_direction;
  if (length(d) == 0.0) context.at("sun_direction").fail("must not be zero");
  if (d.z < std::sin(radians(lowest_sun)) * length(d)) {
    context.at("sun_direction")
        .fail("is more than 10 degrees below the horizon, where it is night",
              "use an environment for the night sky");
  }
  return d;
}

NodeKind sky() {
  Declaration<SkyParameters> d(
      {.name = "sky",
       .doc = "The sky of a clear day and its sun, as bright as they are: film = { exposure = "
              "0.01 } suits noon, 0.04 the last half hour before sunset, 1 dusk.",
       .section = light_section,
       .examples = {"sky { elevation = 40, azimuth = 230 }",
                    "sky { sun_direction = { -1, -2, 1 }, turbidity = 5 }"}});
  d.parameter(
       "elevation", &SkyParameters::elevation,
       {.doc = "How high the sun stands above the horizon; 45 when left out. Below -1, it is "
               "dusk.",
        .unit = Unit::degrees,
        .range = {.min = lowest_sun, .max = 90}})
      .parameter("azimuth", &SkyParameters::azimuth,
                 {.doc = "Where the sun stands as on a compass: 0 towards +y, 90 towards +x.",
                  .unit = Unit::degrees})
      .parameter("sun_direction", &SkyParameters::sun_direction,
                 {.doc = "A point towards the sun, seen from {0, 0, 0}, instead of 'elevation' and "
                         "'azimuth'."})
      .parameter("turbidity", &SkyParameters::turbidity,
                 {.doc = "How much haze there is: 2 is very clear, 3 a little hazy, 6 hazy.",
                  .range = {.min = 1, .max = 10}})
      .parameter("ground_albedo", &SkyParameters::ground_albedo,
                 {.doc = "What the ground, down to the horizon, reflects; it lights the air, too. "
                         "Snow has 0.8.",
                  .range = schema::unit_interval})
      .parameter("sun", &SkyParameters::sun,
                 {.doc = "Whether its sun is a light beside the sky; false leaves the sky alone."})
      .parameter("scale", &SkyParameters::scale,
                 {.doc = "Multiplies the light.", .range = schema::non_negative});
  return node_kind(std::move(d), [](SkyParameters&& s, const Context& context) {
    return light_node(Sky{to_sun(s, context), s.turbidity, s.ground_albedo,
                          s.sun ? Sky::Sun::shines : Sky::Sun::left_out, s.scale},
                      context);
  });
}

}  // namespace

std::vector<NodeKind> environment_kinds() {
  return {environment(), sky()};
}

}  // namespace lapidary::description
