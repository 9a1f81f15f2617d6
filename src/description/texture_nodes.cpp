#include <iterator>

#include "description/nodes.h"
#include "description/texture_arithmetic.h"
#include "description/texture_parameters.h"
#include "description/texture_readers.h"

namespace lapidary::schema {

template <>
struct EnumNames<texture::Gradient::Beyond> {
  using Beyond = texture::Gradient::Beyond;
  static constexpr std::array<std::pair<std::string_view, Beyond>, 3> names{
      {{"clamp", Beyond::clamp}, {"repeat", Beyond::repeat}, {"mirror", Beyond::mirror}}};
};

}  // namespace lapidary::schema

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
       .examples = {"matte(checker { \"white\", \"black\" })",
                    "checker { colors = { 0.8, \"#203040\" }, mapping = \"uv\" }"}});
  d.parameter<ColorPairReader>("colors", &Checker::colors,
                               {.doc = "In turn; the first has its corner at the origin.",
                                .shorthand = Shorthand::yes,
                                .default_text = "{0.8, 0.1}"});
  declare_mapping(d);
  return texture_kind(std::move(d));
}

NodeKind grid() {
  using texture::Grid;
  Declaration<Grid> d({.name = "grid",
                       .doc = "Squares of side 1 with lines between them.",
                       .section = section,
                       .examples = {"grid { \"white\", \"steelblue\" }",
                                    "grid { colors = { 0.9, 0.2 }, width = 0.02 }:scale(0.25)"}});
  d.parameter<ColorPairReader>("colors", &Grid::colors,
                               {.doc = "Of the squares and of the lines.",
                                .shorthand = Shorthand::yes,
                                .default_text = "{0.8, 0.1}"})
      .parameter("width", &Grid::width, {.doc = "Of the lines.", .range = schema::unit_interval});
  declare_mapping(d);
  return texture_kind(std::move(d));
}

void check_bricks(const texture::Bricks& bricks, const Context& context) {
  const Context size = context.at("size");
  if (!(bricks.size.x > 0.0 && bricks.size.y > 0.0)) size.fail("must be greater than 0");
  if (bricks.joint >= bricks.size.x || bricks.joint >= bricks.size.y) {
    context.at("joint").fail("leaves nothing of the bricks", "it is less than both sizes");
  }
}

NodeKind bricks() {
  using texture::Bricks;
  Declaration<Bricks> d(
      {.name = "bricks",
       .doc = "Courses of bricks with mortar between; as a number 1 on bricks and 0 between them.",
       .section = section,
       .examples = {"bricks {}", "bricks { mortar = 0.7, joint = 0.01, size = { 0.25, 0.075 } }"}});
  declare_colors(d, "reds");
  d.parameter<ColorReader>(
       "mortar", &Bricks::mortar,
       {.doc = "Color between the bricks.", .default_text = "{0.55, 0.53, 0.5}"})
      .parameter("size", &Bricks::size,
                 {.doc = "From one brick to the next, and from one course to the next."})
      .parameter("joint", &Bricks::joint,
                 {.doc = "Width of the mortar.", .range = schema::non_negative})
      .parameter("offset", &Bricks::offset,
                 {.doc = "By how much of a brick every second course is moved.",
                  .range = schema::unit_interval});
  declare_seed(d, &Bricks::seed);
  declare_mapping(d);
  return node_kind(std::move(d), [](Bricks&& b, const Context& context) {
    check_bricks(b, context);
    return texture_node(std::move(b), context);
  });
}

NodeKind gradient() {
  using texture::Gradient;
  Declaration<Gradient> d(
      {.name = "gradient",
       .doc = "Colors along a line.",
       .section = section,
       .examples = {"gradient { \"navy\", \"skyblue\", \"white\" }",
                    "gradient { axis = { 0, 0, 2 }, colors = { { 0, \"red\" }, { 0.2, \"gold\" }, "
                    "{ 1, \"white\" } } }"}});
  declare_colors(d, "greys");
  d.parameter("axis", &Gradient::axis, {.doc = "From the origin, where it begins, to its end."})
      .parameter("wrap", &Gradient::beyond, {.doc = "What is before and after that."});
  declare_mapping(d);
  return node_kind(std::move(d), [](Gradient&& g, const Context& context) {
    if (length(g.axis) == 0.0) context.at("axis").fail("must not be zero");
    return texture_node(std::move(g), context);
  });
}

}  // namespace

std::vector<NodeKind> texture_kinds() {
  std::vector<NodeKind> kinds{checker(), grid(), bricks(), gradient()};
  for (auto* others : {noise_kinds, arithmetic_kinds}) {
    auto more = others();
    std::move(more.begin(), more.end(), std::back_inserter(kinds));
  }
  return kinds;
}

}  // namespace lapidary::description
