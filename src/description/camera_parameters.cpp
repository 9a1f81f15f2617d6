#include "description/camera_parameters.h"

#include <fmt/format.h>

namespace lapidary::schema {

description::Shutter Reader<description::Shutter>::read(const Value& value,
                                                        const Context& context) {
  if (value.kind() == ValueKind::number) return {0.0, Reader<double>::read(value, context)};
  if (value.kind() != ValueKind::table) fail_type("a number or {open, close}", value, context);
  const Vec2d times = Reader<Vec2d>::read(value, context);
  if (times.x > times.y) {
    context.fail(fmt::format("closes at {}, before it opens at {}", times.y, times.x));
  }
  return {times.x, times.y};
}

}  // namespace lapidary::schema

namespace lapidary::description {
namespace {

void check_view(const View& view, const schema::Context& context) {
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

}  // namespace

std::optional<ViewChange> ViewChangeReader::read(const schema::Value& value,
                                                 const schema::Context& context) {
  static const auto declaration = schema::Declaration<ViewChange>({.name = "motion", .doc = ""})
                                      .parameter("from", &ViewChange::from, {})
                                      .parameter("at", &ViewChange::at, {})
                                      .parameter("up", &ViewChange::up, {});
  return declaration.read(value, context);
}

std::optional<View> view_at_end(const CameraParameters& camera) {
  if (!camera.motion) return std::nullopt;
  const ViewChange& change = *camera.motion;
  return View{change.from.value_or(camera.from), change.at.value_or(camera.at),
              change.up.value_or(camera.up)};
}

void check_views(const CameraParameters& camera, const schema::Context& context) {
  check_view(camera, context);
  if (const auto end = view_at_end(camera)) check_view(*end, context.at("motion"));
}

}  // namespace lapidary::description
