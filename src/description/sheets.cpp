#include "description/sheets.h"

#include <fmt/format.h>

namespace lapidary::description {
namespace {

using schema::Context;

/// Unit vector to the front.
Vec3d front(const std::optional<Vec3d>& normal, const std::optional<Vec3d>& at, Vec3d center,
            const Context& context) {
  if (normal && at) context.fail("takes either 'normal' or 'at', not both");
  const Vec3d direction = at ? *at - center : normal.value_or(Vec3d{0, 0, 1});
  if (length(direction) == 0.0) {
    context.at(at ? "at" : "normal").fail(at ? "must differ from 'center'" : "must not be zero");
  }
  return normalize(direction);
}

geometry::Rectangle from_edges(const RectangleParameters& r, const Context& context) {
  if (r.center || r.size || r.normal || r.at || !(r.corner && r.edge_u && r.edge_v)) {
    context.fail("needs either 'corner', 'edge_u' and 'edge_v', or 'center', 'size' and 'normal'");
  }
  const double area = length(cross(*r.edge_u, *r.edge_v));
  if (!(area > 1e-12 * length(*r.edge_u) * length(*r.edge_v))) {
    context.at("edge_v").fail("must not be zero or parallel to 'edge_u'");
  }
  return {*r.corner, *r.edge_u, *r.edge_v};
}

}  // namespace

geometry::Rectangle to_rectangle(const RectangleParameters& r, const Context& context) {
  if (r.corner || r.edge_u || r.edge_v) return from_edges(r, context);
  const Vec3d center = r.center.value_or(Vec3d{});
  const Vec3d n = front(r.normal, r.at, center, context);
  // Width runs level; a level rectangle has its width along x.
  const Vec3d level{-n.y, n.x, 0};
  const Vec3d u = length(level) > 1e-9 ? normalize(level) : Vec3d{1, 0, 0};
  const Extent size = r.size.value_or(Extent{});
  const Vec3d edge_u = u * size.width;
  const Vec3d edge_v = normalize(cross(n, u)) * size.height;
  return {center - (edge_u + edge_v) * 0.5, edge_u, edge_v};
}

geometry::Disk to_disk(const DiskParameters& d, const Context& context) {
  return {d.center, front(d.normal, d.at, d.center, context), d.radius};
}

}  // namespace lapidary::description

namespace lapidary::schema {

description::Extent Reader<description::Extent>::read(const Value& value, const Context& context) {
  if (value.kind() == ValueKind::number) {
    const double side = Reader<double>::read(value, context);
    return {side, side};
  }
  const bool pair = value.kind() == ValueKind::table && value.table().items.size() == 2 &&
                    value.table().fields.empty();
  if (!pair) fail_type("{width, height} or a number", value, context);
  return {Reader<double>::read(value.table().items[0], context.at(0)),
          Reader<double>::read(value.table().items[1], context.at(1))};
}

std::string Reader<description::Extent>::text(const description::Extent& extent) {
  return fmt::format("{{{}, {}}}", extent.width, extent.height);
}

}  // namespace lapidary::schema
