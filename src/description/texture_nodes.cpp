#include "description/nodes.h"
#include "description/texture_readers.h"

namespace lapidary::schema {

template <>
struct EnumNames<texture::Checker::Space> {
  static constexpr std::array<std::pair<std::string_view, texture::Checker::Space>, 2> names{
      {{"object", texture::Checker::Space::object}, {"uv", texture::Checker::Space::surface}}};
};

}  // namespace lapidary::schema

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::Node;
using schema::NodeKind;
using schema::Shorthand;

constexpr auto section = "textures";

template <typename Kind>
Node texture_node(Kind kind, const Context& context) {
  return Node::of<texture::Texture>(
      context.call().node,
      std::make_shared<const texture::Texture>(texture::Texture{std::move(kind)}),
      sizeof(texture::Texture));
}

/// A pattern in space, as a scene has it unless it says something else.
struct SolidChecker : texture::Checker {
  SolidChecker() { space = Space::object; }
};

NodeKind checker() {
  Declaration<SolidChecker> d(
      {.name = "checker",
       .doc = "Cubes in space, or squares on a surface, of two colors in turn.",
       .section = section,
       .examples = {"checker { \"white\", \"black\" }",
                    "checker { colors = { 0.8, \"#203040\" }, mapping = \"uv\" }"}});
  d.parameter<ColorPairReader>("colors", &SolidChecker::colors,
                               {.doc = "In turn; the first has its corner at the origin.",
                                .shorthand = Shorthand::yes,
                                .default_text = "{0.8, 0.1}"})
      .parameter("mapping", &SolidChecker::space,
                 {.doc = "Where the pattern is: in the space in which the object was written, or "
                         "in the coordinates of its surface."});
  return node_kind(std::move(d), [](SolidChecker&& c, const Context& context) {
    return texture_node(texture::Checker(std::move(c)), context);
  });
}

}  // namespace

std::vector<NodeKind> texture_kinds() {
  return {checker()};
}

}  // namespace lapidary::description
