#include "description/nodes.h"
#include "description/object_node.h"

namespace lapidary::description {
namespace {

struct GroupParameters {
  std::vector<ObjectPtr> objects;
};

}  // namespace

std::vector<schema::NodeKind> group_kinds() {
  using Parameters = ObjectOf<GroupParameters>;
  schema::Declaration<Parameters> d(
      {.name = "group",
       .doc = "Objects that move and are named together; they keep what they wear.",
       .section = "groups",
       .examples = {"group { sphere {}, box { size = { 1, 1, 3 } } }",
                    "group { { sphere {}, sphere { center = { 3, 0, 0 } } }, name = \"pair\" }"}});
  d.parameter<ObjectListReader>("objects", &GroupParameters::objects,
                                {.doc = "Its members.", .shorthand = schema::Shorthand::yes});
  return {node_kind(declare_object(d), [](Parameters&& g, const schema::Context& context) {
    const ObjectPtr group = make_group(std::move(g.objects), context.call().where);
    schema::Node node = object_node(group->content, std::move(g), context);
    node.bytes +=
        std::get<std::shared_ptr<const Group>>(group->content)->children.size() * sizeof(ObjectPtr);
    return node;
  })};
}

}  // namespace lapidary::description
