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

}  // namespace lapidary::schema

namespace lapidary::description {

inline constexpr auto camera_section = "cameras";

/// The parameters of a node that makes a camera: those of a model T, and the common ones.
template <typename T>
struct CameraOf : T, View {};

/// Adds the common parameters of cameras.
template <typename T>
schema::Declaration<T>& declare_camera(schema::Declaration<T>& declaration) {
  using schema::Unit;
  return declaration
      .parameter("from", &View::from, {.doc = "Where the camera stands.", .unit = Unit::length})
      .parameter("at", &View::at, {.doc = "A point in the picture's middle.", .unit = Unit::length})
      .parameter("up", &View::up, {.doc = "What is up in the picture."});
}

/// Throws Error where no camera can look like this.
void check_view(const View& view, const schema::Context& context);

/// The camera of a model whose own parameters are read and checked.
template <typename T>
schema::Node camera_node(CameraOf<T>&& parameters, const schema::Context& context) {
  parameters.view = parameters;
  auto camera =
      std::make_shared<Camera>(Camera{static_cast<T&&>(parameters), context.call().where});
  return schema::Node::of<Camera>(context.call().node, std::move(camera), sizeof(Camera));
}

}  // namespace lapidary::description
