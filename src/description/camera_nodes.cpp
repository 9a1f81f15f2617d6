#include <fmt/format.h>

#include "description/camera_parameters.h"
#include "description/nodes.h"
#include "math/constants.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Unit;
using schema::Value;
using schema::ValueKind;

constexpr auto open = schema::Range::End::open;

/// A distance along the view, or a point that is to be sharp.
using Focus = std::variant<double, Vec3d>;

struct FocusReader {
  static std::string type() { return "number or {x, y, z}"; }
  static std::optional<Focus> read(const Value& value, const Context& context) {
    if (value.kind() != ValueKind::number) return schema::Reader<Vec3d>::read(value, context);
    const double distance = schema::Reader<double>::read(value, context);
    if (!(distance > 0.0)) context.fail(fmt::format("must be greater than 0, not {}", distance));
    return distance;
  }
  static std::string text(const std::optional<Focus>&) { return ""; }
};

/// Two numbers {x, y}, or one of them by name.
struct AcrossReader {
  static std::string type() { return "{x, y}"; }
  static Vec2d read(const Value& value, const Context& context) {
    constexpr std::array<std::string_view, 2> axes{"x", "y"};
    if (value.kind() != ValueKind::table) schema::fail_type("{x, y}", value, context);
    const auto [items, fields] = value.table();
    Vec2d v;
    if (fields.empty()) {
      if (items.size() != 2) schema::fail_type("two numbers {x, y}", value, context);
      for (std::size_t i = 0; i < 2; ++i) {
        v[i] = schema::Reader<double>::read(items[i], context.at(axes[i]));
      }
      return v;
    }
    if (!items.empty()) context.fail("must be either {1, 2} or {x = 1, y = 2}, not both");
    for (const schema::Field& field : fields) {
      const std::size_t axis = schema::read_word(Value(field.key), axes, context);
      v[axis] = schema::Reader<double>::read(field.value, context.at(axes[axis]));
    }
    return v;
  }
  static std::string text(const Vec2d& v) { return fmt::format("{{{}, {}}}", v.x, v.y); }
};

struct PerspectiveParameters : CameraOf<Perspective> {
  std::optional<Focus> focus;
};

std::optional<double> focus_distance(const PerspectiveParameters& p, const Context& context) {
  if (!p.focus) return std::nullopt;
  if (const auto* distance = std::get_if<double>(&*p.focus)) return *distance;
  const Vec3d forward = normalize(p.at - p.from);
  const Vec3d right = normalize(cross(forward, p.up)),
              to_focus = std::get<Vec3d>(*p.focus) - p.from;
  const double along = dot(to_focus, forward);
  if (!(along > 0.0)) context.at("focus").fail("is a point behind the camera");
  // The plane through the point, back to the view's axis.
  const double distance = along -
                          dot(to_focus, cross(right, forward)) * std::tan(radians(p.tilt.x)) -
                          dot(to_focus, right) * std::tan(radians(p.tilt.y));
  if (!(distance > 0.0)) {
    context.at("tilt").fail(
        "turns the plane through 'focus' so far that it passes behind the camera",
        "tilt it less, or focus on a point nearer to the picture's middle");
  }
  return distance;
}

void check_blades(int blades, const Context& context) {
  if (blades == 0 || blades >= 3) return;
  context.at("blades").fail(fmt::format("must be at least 3, not {}", blades),
                            "a polygon has three corners or more; 0 is a round aperture");
}

void declare_aperture(Declaration<PerspectiveParameters>& d) {
  using P = PerspectiveParameters;
  d.parameter("aperture", &P::aperture,
              {.doc = "Diameter of the lens; 0 has everything sharp.",
               .unit = Unit::length,
               .range = schema::non_negative})
      .parameter<FocusReader>("focus", &P::focus,
                              {.doc = "What is sharp: a distance along the view, or a point; 'at' "
                                      "when left out.",
                               .unit = Unit::length})
      .parameter("blades", &P::blades,
                 {.doc = "Corners of the aperture, and so of lights out of focus: 3 or more; 0 for "
                         "round.",
                  .range = {.min = 0, .max = 1000}})
      .parameter("blade_rotation", &P::blade_rotation,
                 {.doc = "Turns them counter-clockwise from one that points right.",
                  .unit = Unit::degrees})
      .parameter("anamorphic", &P::anamorphic,
                 {.doc = "How many times taller than wide lights out of focus are; 2 as of lenses "
                         "for wide films.",
                  .range = {.min = 0.01, .max = 100}});
}

void declare_movements(Declaration<PerspectiveParameters>& d) {
  using P = PerspectiveParameters;
  d.parameter<AcrossReader>(
       "shift", &P::shift,
       {.doc = "Slides the picture to the right and up by these shares of its longer side; keeps "
               "upright lines upright.",
        .range = {.min = -100, .max = 100}})
      .parameter<AcrossReader>(
          "tilt", &P::tilt,
          {.doc = "Turns the sharp plane, not the view: x leans its top away, y its right side.",
           .unit = Unit::degrees,
           .range = {.min = -90, .max = 90, .min_end = open, .max_end = open}});
}

NodeKind perspective() {
  using P = PerspectiveParameters;
  Declaration<P> d(
      {.name = "perspective",
       .doc = "A camera that sees as eyes and lenses do.",
       .section = camera_section,
       .examples = {
           "perspective { from = { 4, -7, 4 }, at = { 0, 0, 1 }, fov = 30 }",
           "perspective { from = { 0, -9, 2 }, aperture = 0.4, blades = 6, blade_rotation = 15 }",
           "perspective { from = { 0, -9, 1 }, at = { 0, 0, 1 }, shift = { y = 0.3 } }",
           "perspective { from = { 0, -9, 2 }, motion = { from = { 1, -9, 2 } }, shutter = 0.5 }",
           "perspective { from = { 0, -9, 6 }, aperture = 0.8, tilt = { x = 50 } }"}});
  declare_camera(d)
      .parameter("fov", &P::fov,
                 {.doc = "How much the picture shows, from side to side along 'fov_axis'.",
                  .unit = Unit::degrees,
                  .range = {.min = 0, .max = 180, .min_end = open, .max_end = open}})
      .parameter("fov_axis", &P::fov_axis, {.doc = "Which side of the picture 'fov' spans."});
  declare_aperture(d);
  declare_movements(d);
  return node_kind(std::move(d), [](P&& p, const Context& context) {
    check_views(p, context);
    check_blades(p.blades, context);
    p.focus_distance = focus_distance(p, context);
    return camera_node<Perspective>(std::move(p), context);
  });
}

NodeKind orthographic() {
  using O = CameraOf<Orthographic>;
  Declaration<O> d(
      {.name = "orthographic",
       .doc = "A camera for plans: parallel lines stay parallel.",
       .section = camera_section,
       .examples = {
           "orthographic { from = { 0, 0, 9 }, at = { 0, 0, 0 }, up = { 0, 1, 0 }, size = 4 }"}});
  declare_camera(d)
      .parameter("size", &O::size,
                 {.doc = "How much the picture shows, from side to side along 'fov_axis'.",
                  .unit = Unit::length,
                  .range = schema::positive})
      .parameter("fov_axis", &O::fov_axis, {.doc = "Which side of the picture 'size' spans."});
  return node_kind(std::move(d), [](O&& o, const Context& context) {
    check_views(o, context);
    return camera_node<Orthographic>(std::move(o), context);
  });
}

}  // namespace

std::vector<NodeKind> camera_kinds() {
  return {perspective(), orthographic()};
}

}  // namespace lapidary::description
