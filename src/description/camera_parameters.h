#pragma once

#include "description/camera.h"
#include "schema/node_kind.h"

namespace lapidary::schema {

template <>
struct EnumNames<description::FovAxis> {
  static constexpr std::array<std::pair<std::string_view, description::FovAxis>, 3> names{
      {{"shorter", description::FovAxis::shorter},
       {"x", description::FovAxis::x},
       {"y", description::FovAxis::y}}};
};

template <>
struct Reader<description::Shutter> {
  static std::string type() { return "number or {open, close}"; }
  static description::Shutter read(const Value& value, const Context& context);
  static std::string text(const description::Shutter& s) {
    return Reader<Vec2d>::text({s.open, s.close});
  }
};

}  // namespace lapidary::schema

namespace lapidary::description {

/// What is given of where a moving camera is when the frame ends.
struct ViewChange {
  std::optional<Vec3d> from, at, up;
};

struct ViewChangeReader {
  static std::string type() { return "{from = , at = , up = }"; }
  static std::optional<ViewChange> read(const schema::Value& value, const schema::Context& context);
  static std::string text(const std::optional<ViewChange>&) { return ""; }
};

inline constexpr auto camera_section = "cameras";

/// What every camera has besides its model.
struct CameraParameters : View {
  Shutter shutter;
  std::optional<ViewChange> motion;
};

/// The parameters of a node that makes a camera: those of a model T, and the common ones.
template <typename T>
struct CameraOf : T, CameraParameters {};

/// Adds the common parameters of cameras.
template <typename T>
schema::Declaration<T>& declare_camera(schema::Declaration<T>& declaration) {
  using schema::Unit;
  return declaration
      .parameter("from", &View::from, {.doc = "Where the camera stands.", .unit = Unit::length})
      .parameter("at", &View::at, {.doc = "A point in the picture's middle.", .unit = Unit::length})
      .parameter("up", &View::up, {.doc = "What is up in the picture."})
      .parameter(
          "shutter", &CameraParameters::shutter,
          {.doc = "The part of the frame in which the picture is taken, for the blur of what "
                  "moves: {open, close}, or a number that is when it closes.",
           .range = schema::unit_interval})
      .template parameter<ViewChangeReader>(
          "motion", &CameraParameters::motion,
          {.doc = "Where the camera has moved when the frame ends: its 'from', 'at' and 'up' then, "
                  "as far as they change. It turns evenly on the way."});
}

/// Throws Error where no camera can look like this, at the beginning or the end of the frame.
void check_views(const CameraParameters& camera, const schema::Context& context);

/// Where it is when the frame ends; nothing if it stands still.
std::optional<View> view_at_end(const CameraParameters& camera);

/// The camera of a model whose own parameters are read and checked.
template <typename T>
schema::Node camera_node(CameraOf<T>&& parameters, const schema::Context& context) {
  parameters.view = parameters;
  auto camera = std::make_shared<Camera>(Camera{static_cast<T&>(parameters), context.call().where,
                                                parameters.shutter, view_at_end(parameters)});
  return schema::Node::of<Camera>(context.call().node, std::move(camera), sizeof(Camera));
}

}  // namespace lapidary::description
