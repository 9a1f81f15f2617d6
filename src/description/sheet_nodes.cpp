#include "description/nodes.h"
#include "description/object_node.h"
#include "description/sheets.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::NodeKind;

constexpr auto section = "sheets and meshes";

NodeKind rectangle() {
  using Parameters = ObjectOf<RectangleParameters>;
  Declaration<Parameters> d({.name = "rectangle",
                             .doc = "A flat sheet with four sides; it encloses nothing.",
                             .section = section,
                             .examples = {"rectangle { size = { 4, 3 }, normal = { 0, -1, 0 } }",
                                          "rectangle { corner = { 0, 0, 0 }, edge_u = { 4, 0, 0 }, "
                                          "edge_v = { 0, 0, 3 } }"}});
  return node_kind(declare_sheet(declare_rectangle(d)), [](Parameters&& r, const Context& context) {
    return object_node(geometry::Sheet(to_rectangle(r, context)), std::move(r), context);
  });
}

NodeKind disk() {
  using Parameters = ObjectOf<DiskParameters>;
  Declaration<Parameters> d(
      {.name = "disk",
       .doc = "A flat round sheet; it encloses nothing.",
       .section = section,
       .examples = {"disk { center = { 0, 0, 1 }, radius = 0.5, at = { 0, -5, 1 } }"}});
  return node_kind(declare_sheet(declare_disk(d)), [](Parameters&& p, const Context& context) {
    return object_node(geometry::Sheet(to_disk(p, context)), std::move(p), context);
  });
}

}  // namespace

std::vector<NodeKind> sheet_kinds() {
  return {rectangle(), disk()};
}

}  // namespace lapidary::description
