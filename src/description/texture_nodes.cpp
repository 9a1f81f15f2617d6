#include "description/nodes.h"
#include "description/texture_parameters.h"
#include "description/texture_readers.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Shorthand;

constexpr auto section = "textures";

NodeKind checker() {
  using texture::Checker;
  Declaration<Checker> d(
      {.name = "checker",
       .doc = "Cubes in space, or squares on a surface, of side 1 and of two colors in turn.",
       .section = section,
       .examples = {"checker { \"white\", \"black\" }",
                    "checker { colors = { 0.8, \"#203040\" }, mapping = \"uv\" }"}});
  d.parameter<ColorPairReader>("colors", &Checker::colors,
                               {.doc = "In turn; the first has its corner at the origin.",
                                .shorthand = Shorthand::yes,
                                .default_text = "{0.8, 0.1}"});
  declare_mapping(d);
  return node_kind(std::move(d), [](Checker&& c, const Context& context) {
    return texture_node(std::move(c), context);
  });
}

}  // namespace

std::vector<NodeKind> texture_kinds() {
  return {checker()};
}

}  // namespace lapidary::description
