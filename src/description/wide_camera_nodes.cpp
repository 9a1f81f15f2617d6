#include <fmt/format.h>

#include "description/camera_parameters.h"
#include "description/nodes.h"

namespace lapidary::schema {

template <>
struct EnumNames<description::FisheyeMapping> {
  using Mapping = description::FisheyeMapping;
  static constexpr std::array<std::pair<std::string_view, Mapping>, 4> names{
      {{"equidistant", Mapping::equidistant},
       {"equisolid", Mapping::equisolid},
       {"stereographic", Mapping::stereographic},
       {"orthographic", Mapping::orthographic}}};
};

}  // namespace lapidary::schema

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Unit;

/// Two numbers, ascending.
struct RangeReader {
  static std::string type() { return "{from, to}"; }
  static Vec2d read(const schema::Value& value, const Context& context) {
    const Vec2d range = schema::Reader<Vec2d>::read(value, context);
    if (!(range.x < range.y)) {
      context.fail(fmt::format("must ascend, not go from {} to {}", range.x, range.y));
    }
    return range;
  }
  static std::string text(const Vec2d& v) { return schema::Reader<Vec2d>::text(v); }
};

NodeKind panorama() {
  using P = CameraOf<Panorama>;
  Declaration<P> d(
      {.name = "panorama",
       .doc = "A camera that sees everything around, laid out as environment pictures are "
              "(equirectangular): twice as wide as high. It turns towards 'at' but never leans.",
       .section = camera_section,
       .examples = {"panorama { from = { 0, 0, 1.7 }, at = { 0, 1, 1.7 } }",
                    "panorama { from = { 0, 0, 1.7 }, at = { 0, 1, 1.7 }, longitude = { -90, 90 }, "
                    "latitude = { -30, 60 } }"}});
  declare_camera(d)
      .parameter<RangeReader>("longitude", &P::longitude,
                              {.doc = "From the left edge to the right; 0 towards 'at', 90 to its "
                                      "right. At most 360 in all.",
                               .unit = Unit::degrees,
                               .range = {.min = -360, .max = 360}})
      .parameter<RangeReader>("latitude", &P::latitude,
                              {.doc = "From the lower edge to the upper; 90 is straight up.",
                               .unit = Unit::degrees,
                               .range = {.min = -90, .max = 90}});
  return node_kind(std::move(d), [](P&& p, const Context& context) {
    check_views(p, context);
    const double width = p.longitude.y - p.longitude.x;
    if (width > 360.0) {
      context.at("longitude").fail(fmt::format("must span at most 360 degrees, not {}", width));
    }
    return camera_node<Panorama>(std::move(p), context);
  });
}

/// What a mapping cannot show.
void check_fov(const Fisheye& f, const Context& context) {
  const Context fov = context.at("fov");
  if (f.mapping == FisheyeMapping::stereographic && f.fov >= 360.0) {
    fov.fail("must be less than 360 where the mapping is stereographic",
             "what is behind the camera would be infinitely far from the middle");
  }
  if (f.mapping == FisheyeMapping::orthographic && f.fov > 180.0) {
    fov.fail(fmt::format("must be at most 180 where the mapping is orthographic, not {}", f.fov),
             "the other mappings see more");
  }
}

NodeKind fisheye() {
  using F = CameraOf<Fisheye>;
  Declaration<F> d(
      {.name = "fisheye",
       .doc = "A camera that sees up to everything in one round picture, with black around it.",
       .section = camera_section,
       .examples = {"fisheye { from = { 0, 0, 1.7 }, at = { 0, 1, 1.7 } }",
                    "fisheye { from = { 0, 0, 1.7 }, at = { 0, 1, 1.7 }, fov = 220, mapping = "
                    "\"equisolid\" }"}});
  declare_camera(d)
      .parameter("fov", &F::fov,
                 {.doc = "How much the circle shows, from side to side: up to 360, or 180 where "
                         "the mapping is orthographic.",
                  .unit = Unit::degrees,
                  .range = {.min = 0, .max = 360, .min_end = schema::Range::End::open}})
      .parameter("fov_axis", &F::fov_axis, {.doc = "Which side of the picture the circle spans."})
      .parameter(
          "mapping", &F::mapping,
          {.doc = "What the distance from the middle grows with: the angle; its sine of half "
                  "(equal areas stay equal), tangent of half (shapes stay), or sine."});
  return node_kind(std::move(d), [](F&& f, const Context& context) {
    check_views(f, context);
    check_fov(f, context);
    return camera_node<Fisheye>(std::move(f), context);
  });
}

}  // namespace

std::vector<NodeKind> wide_camera_kinds() {
  return {panorama(), fisheye()};
}

}  // namespace lapidary::description
