#include <fmt/format.h>

#include "description/camera.h"
#include "description/nodes.h"
#include "math/constants.h"

namespace lapidary::schema {

template <>
struct EnumNames<description::FovAxis> {
  static constexpr std::array<std::pair<std::string_view, description::FovAxis>, 3> names{
      {{"shorter", description::FovAxis::shorter},
       {"x", description::FovAxis::x},
       {"y", description::FovAxis::y}}};
};

}  // namespace lapidary::schema

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::Node;
using schema::NodeKind;
using schema::Unit;
using schema::Value;
using schema::ValueKind;

constexpr auto section = "cameras";

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

struct PerspectiveParameters : View, Perspective {
  std::optional<Focus> focus;
};

struct OrthographicParameters : View, Orthographic {};

template <typename T>
Declaration<T>& declare_view(Declaration<T>& d) {
  return d.parameter("from", &View::from, {.doc = "Where the camera stands.", .unit = Unit::length})
      .parameter("at", &View::at, {.doc = "A point in the picture's middle.", .unit = Unit::length})
      .parameter("up", &View::up, {.doc = "What is up in the picture."});
}

void check_view(const View& view, const Context& context) {
  if (view.from == view.at) {
    context.at("at").fail("must differ from 'from'", "the camera stands at what it looks at");
  }
  if (length(view.up) == 0.0) context.at("up").fail("must not be zero");
  const Vec3d forward = normalize(view.at - view.from);
  // Within a millionth of a degree of it, no digit of the horizon would be left.
  if (length(cross(forward, normalize(view.up))) < 1e-8) {
    context.at("up").fail("must not be parallel to the view",
                          "looking straight down or up, say up = {0, 1, 0}");
  }
}

std::optional<double> focus_distance(const PerspectiveParameters& p, const Context& context) {
  if (!p.focus) return std::nullopt;
  if (const auto* distance = std::get_if<double>(&*p.focus)) return *distance;
  const Vec3d forward = normalize(p.at - p.from);
  const double distance = dot(std::get<Vec3d>(*p.focus) - p.from, forward);
  if (!(distance > 0.0)) context.at("focus").fail("is a point behind the camera");
  return distance;
}

template <typename Model>
Node camera_node(Model model, const Context& context) {
  auto camera = std::make_shared<Camera>(Camera{std::move(model), context.call().where});
  return Node::of<Camera>(context.call().node, std::move(camera), sizeof(Camera));
}

NodeKind perspective() {
  using P = PerspectiveParameters;
  constexpr auto open = schema::Range::End::open;
  Declaration<P> d(
      {.name = "perspective",
       .doc = "A camera that sees as eyes and lenses do.",
       .section = section,
       .examples = {"perspective { from = { 4, -7, 4 }, at = { 0, 0, 1 }, fov = 30 }"}});
  declare_view(d)
      .parameter("fov", &P::fov,
                 {.doc = "How much the picture shows, from side to side along 'fov_axis'.",
                  .unit = Unit::degrees,
                  .range = {.min = 0, .max = 180, .min_end = open, .max_end = open}})
      .parameter("fov_axis", &P::fov_axis, {.doc = "Which side of the picture 'fov' spans."})
      .parameter("aperture", &P::aperture,
                 {.doc = "Diameter of the lens; 0 has everything sharp.",
                  .unit = Unit::length,
                  .range = schema::non_negative})
      .parameter<FocusReader>("focus", &P::focus,
                              {.doc = "What is sharp: a distance along the view, or a point; 'at' "
                                      "when left out.",
                               .unit = Unit::length});
  return node_kind(std::move(d), [](P&& p, const Context& context) {
    check_view(p, context);
    p.view = p;
    p.focus_distance = focus_distance(p, context);
    return camera_node(static_cast<const Perspective&>(p), context);
  });
}

NodeKind orthographic() {
  using O = OrthographicParameters;
  Declaration<O> d(
      {.name = "orthographic",
       .doc = "A camera for plans: parallel lines stay parallel.",
       .section = section,
       .examples = {
           "orthographic { from = { 0, 0, 9 }, at = { 0, 0, 0 }, up = { 0, 1, 0 }, size = 4 }"}});
  declare_view(d)
      .parameter("size", &O::size,
                 {.doc = "How much the picture shows, from side to side along 'fov_axis'.",
                  .unit = Unit::length,
                  .range = schema::positive})
      .parameter("fov_axis", &O::fov_axis, {.doc = "Which side of the picture 'size' spans."});
  return node_kind(std::move(d), [](O&& o, const Context& context) {
    check_view(o, context);
    o.view = o;
    return camera_node(static_cast<const Orthographic&>(o), context);
  });
}

}  // namespace

std::vector<NodeKind> camera_kinds() {
  return {perspective(), orthographic()};
}

}  // namespace lapidary::description
