#include <fmt/format.h>

#include "description/emission_parameters.h"
#include "description/light_node.h"
#include "description/nodes.h"
#include "description/object_node.h"
#include "description/sheets.h"

namespace lapidary::description {
namespace {

using geometry::Sheet;
using geometry::Solid;
using geometry::Sphere;
using schema::Context;
using schema::Declaration;
using schema::Node;
using schema::NodeKind;
using schema::Unit;

constexpr auto section = light_section;

/// A light with a surface: a shape T that gives light.
template <typename T>
struct LightOf : T, EmissionParameters {
  std::string name;
};

struct MeshLightParameters {
  ObjectPtr shape;
};

constexpr auto surface_strengths = {Strength::power, Strength::radiance, Strength::lumens,
                                    Strength::nits};
constexpr auto point_strengths = {Strength::power, Strength::intensity, Strength::lumens,
                                  Strength::candela};
constexpr auto distant_strengths = {Strength::irradiance, Strength::lux};

template <typename T>
Declaration<LightOf<T>>& declare_surface_light(Declaration<LightOf<T>>& d) {
  declare_emission(d, surface_strengths);
  return d.parameter("name", &LightOf<T>::name, {.doc = "For reports and layers."});
}

MaterialPtr emissive_material(const EmissionParameters& e, const Context& context) {
  auto material = std::make_shared<Material>();
  material->model = Emissive{to_emission(e, surface_strengths, context)};
  material->where = context.call().where;
  return material;
}

/// An object of shape `content` that wears the emission of `light`.
template <typename T, typename Content>
Node surface_light(Content content, LightOf<T>&& light, const Context& context) {
  ObjectParameters common;
  common.material = emissive_material(light, context);
  common.name = std::move(light.name);
  return object_node(std::move(content), std::move(common), context);
}

NodeKind sphere_light() {
  Declaration<LightOf<Sphere>> d(
      {.name = "sphere_light",
       .doc = "A glowing ball.",
       .section = section,
       .examples = {"sphere_light { center = { 0, 0, 4 }, radius = 0.5, power = 300 }",
                    "sphere_light { radius = 0.03, lumens = 806, temperature = 2700 }"}});
  d.parameter("center", &Sphere::center, {.doc = "Its centre.", .unit = Unit::length})
      .parameter("radius", &Sphere::radius,
                 {.doc = "Distance from the centre to the surface.",
                  .unit = Unit::length,
                  .range = schema::positive});
  return node_kind(declare_surface_light(d), [](LightOf<Sphere>&& s, const Context& context) {
    return surface_light(Solid(static_cast<const Sphere&>(s)), std::move(s), context);
  });
}

NodeKind rectangle_light() {
  using Parameters = LightOf<RectangleParameters>;
  Declaration<Parameters> d(
      {.name = "rectangle_light",
       .doc = "A flat panel that gives light from its front; its back is black.",
       .section = section,
       .examples = {"rectangle_light { center = { 0, 0, 5 }, at = { 0, 0, 0 }, power = 400 }"}});
  return node_kind(declare_surface_light(declare_rectangle(d)),
                   [](Parameters&& r, const Context& context) {
                     return surface_light(Sheet(to_rectangle(r, context)), std::move(r), context);
                   });
}

NodeKind disk_light() {
  using Parameters = LightOf<DiskParameters>;
  Declaration<Parameters> d(
      {.name = "disk_light",
       .doc = "A flat round panel that gives light from its front; its back is black.",
       .section = section,
       .examples = {"disk_light { center = { 0, 0, 5 }, at = { 0, 0, 0 }, radiance = 4, "
                    "temperature = 3000 }"}});
  return node_kind(declare_surface_light(declare_disk(d)),
                   [](Parameters&& p, const Context& context) {
                     return surface_light(Sheet(to_disk(p, context)), std::move(p), context);
                   });
}

NodeKind mesh_light() {
  using Parameters = LightOf<MeshLightParameters>;
  Declaration<Parameters> d(
      {.name = "mesh_light",
       .doc = "Any object, all of it giving light. Every part of a group "
              "has the stated power.",
       .section = section,
       .examples = {"mesh_light { shape = box { size = { 2, 0.1, 0.1 } }, power = 100 }"}});
  d.parameter("shape", &MeshLightParameters::shape,
              {.doc = "What gives the light.",
               .need = schema::Need::required,
               .shorthand = schema::Shorthand::yes});
  return node_kind(declare_surface_light(d), [](Parameters&& m, const Context& context) {
    ObjectPtr object = with_material_everywhere(*m.shape, emissive_material(m, context));
    if (!m.name.empty()) object = with_name(*object, m.name);
    return Node::of<Object>(context.call().node, std::move(object), sizeof(Object));
  });
}

struct PointParameters : EmissionParameters {
  Vec3d position;
  std::optional<schema::InputFile> profile;
  std::optional<Vec3d> at, up;
};

/// What a profile's horizontal angle 0 is turned to when nothing is said.
Vec3d usual_up(Vec3d axis) {
  const bool along_y = length(cross(axis, Vec3d(0, 1, 0))) < 1e-6 * length(axis);
  return along_y ? Vec3d(0, 0, 1) : Vec3d(0, 1, 0);
}

ProfileLight profile_light(const PointParameters& p, const Context& context) {
  if (p.intensity || p.candela) {
    context.fail(fmt::format("has its {} from the profile", p.candela ? "candela" : "intensity"),
                 "leave it out, or state 'lumens' or 'power' to scale the profile to that");
  }
  ProfileLight light{.file = p.profile->path, .position = p.position};
  if (p.at) light.axis = *p.at - p.position;
  if (length(light.axis) == 0.0) context.at("at").fail("must differ from 'position'");
  light.up = p.up.value_or(usual_up(light.axis));
  if (!(length(cross(light.axis, light.up)) > 1e-9 * length(light.axis) * length(light.up))) {
    context.at("up").fail("must not be along the way from 'position' to 'at'");
  }
  const auto stated = to_stated_emission(p, {Strength::power, Strength::lumens}, context);
  light.emission = stated ? *stated : Emission{Quantity::intensity, one_candela(p, context)};
  return light;
}

NodeKind point_light() {
  Declaration<PointParameters> d(
      {.name = "point_light",
       .doc = "Light from one point: all around alike, or as a luminaire was measured.",
       .section = section,
       .examples = {"point_light { position = { 0, -2, 4 }, power = 300 }",
                    "point_light { position = { 0, 0, 3 }, profile = \"lamp.ies\" }"}});
  d.parameter("position", &PointParameters::position, {.doc = "Where it is.", .unit = Unit::length})
      .parameter("profile", &PointParameters::profile,
                 {.doc = "An IES file (LM-63, photometry type A, B or C) with the candela in every "
                         "direction; 'power' or 'lumens' scale them to that sum, and no strength "
                         "leaves them as they are."})
      .parameter("at", &PointParameters::at,
                 {.doc = "A point that the axis of the profile points at; straight down when left "
                         "out.",
                  .unit = Unit::length})
      .parameter("up", &PointParameters::up,
                 {.doc = "Turns the profile about its axis: where its horizontal angle 0 points, "
                         "of types A and B where its vertical angles grow, as far as the axis lets "
                         "it; {0, 1, 0} when left out."});
  return node_kind(declare_emission(d, point_strengths), [](PointParameters&& p,
                                                            const Context& context) {
    if (p.profile) return light_node(profile_light(p, context), context);
    if (p.at || p.up) {
      context.at(p.at ? "at" : "up")
          .fail("aims a profile, and there is none", "give a 'profile', or use spot_light");
    }
    return light_node(PointLight{p.position, to_emission(p, point_strengths, context)}, context);
  });
}

struct SpotParameters : SpotLight, EmissionParameters {};

NodeKind spot_light() {
  Declaration<SpotParameters> d(
      {.name = "spot_light",
       .doc = "Light from one point within a cone.",
       .section = section,
       .examples = {
           "spot_light { from = { 0, -4, 6 }, at = { 0, 0, 0 }, angle = 30, power = 200 }"}});
  d.parameter("from", &SpotLight::from, {.doc = "Where it is.", .unit = Unit::length})
      .parameter("at", &SpotLight::at, {.doc = "A point it shines at.", .unit = Unit::length})
      .parameter("angle", &SpotLight::angle,
                 {.doc = "From one side of the cone to the other.",
                  .unit = Unit::degrees,
                  .range = {.min = 0, .max = 180, .min_end = schema::Range::End::open}})
      .parameter("penumbra", &SpotLight::penumbra,
                 {.doc = "Share of the cone's half angle over which light fades to its rim.",
                  .range = schema::unit_interval});
  return node_kind(declare_emission(d, point_strengths),
                   [](SpotParameters&& s, const Context& context) {
                     if (s.from == s.at) context.at("at").fail("must differ from 'from'");
                     s.emission = to_emission(s, point_strengths, context);
                     return light_node(static_cast<const SpotLight&>(s), context);
                   });
}

/// A distant light as people say it: where it comes from, or which way it shines.
struct DistantParameters : EmissionParameters {
  std::optional<Vec3d> from, direction;
  double angle = 0;
};

NodeKind distant_light() {
  Declaration<DistantParameters> d(
      {.name = "distant_light",
       .doc = "Light from one direction everywhere, as from the sun.",
       .section = section,
       .examples = {"distant_light { direction = { 1, 0, -1 }, irradiance = 2 }"}});
  d.parameter("from", &DistantParameters::from,
              {.doc = "A point in the direction it comes from, seen from {0, 0, 0}; above when "
                      "left out."})
      .parameter("direction", &DistantParameters::direction,
                 {.doc = "The way it shines, instead of 'from'."})
      .parameter("angle", &DistantParameters::angle,
                 {.doc = "Its diameter in the sky; the sun's is 0.53.",
                  .unit = Unit::degrees,
                  .range = {.min = 0, .max = 180, .max_end = schema::Range::End::open}});
  return node_kind(declare_emission(d, distant_strengths),
                   [](DistantParameters&& s, const Context& context) {
                     if (s.from && s.direction)
                       context.fail("takes either 'from' or 'direction', not both");
                     DistantLight light;
                     if (s.from) light.direction = -*s.from;
                     if (s.direction) light.direction = *s.direction;
                     if (length(light.direction) == 0.0) {
                       context.at(s.from ? "from" : "direction").fail("must not be zero");
                     }
                     light.angle = s.angle;
                     light.emission = to_emission(s, distant_strengths, context);
                     return light_node(std::move(light), context);
                   });
}

}  // namespace

std::vector<NodeKind> light_kinds() {
  const NodeKind distant = distant_light();
  return {sphere_light(),
          rectangle_light(),
          disk_light(),
          mesh_light(),
          point_light(),
          spot_light(),
          distant,
          alias(distant, "sun", "Another name for distant_light.",
                {"sun { from = { -2, -3, 4 }, angle = 0.53, irradiance = 3 }"})};
}

}  // namespace lapidary::description
