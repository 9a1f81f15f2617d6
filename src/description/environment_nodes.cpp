#include "description/color_readers.h"
#include "description/light_node.h"
#include "description/nodes.h"

namespace lapidary::description {
namespace {

using schema::Context;
using schema::Declaration;
using schema::NodeKind;
using schema::Unit;

struct EnvironmentParameters {
  std::optional<schema::InputFile> file;
  std::optional<Spectrum> color;
  double scale = 1;
  double rotate = 0;
};

NodeKind environment() {
  Declaration<EnvironmentParameters> d(
      {.name = "environment",
       .doc = "Light from all around: a picture, or one color.",
       .section = light_section,
       .examples = {"environment \"sky.hdr\"", "environment { color = { 0.3, 0.4, 0.6 } }"}});
  d.parameter("file", &EnvironmentParameters::file,
              {.doc = "A picture of everything around, twice as wide as high; its top is +z, its "
                      "middle +y.",
               .shorthand = schema::Shorthand::yes})
      .parameter<Optional<LightReader>>("color", &EnvironmentParameters::color,
                                        {.doc = "The radiance everywhere, instead of 'file'; 1 "
                                                "when both are left out.",
                                         .unit = Unit::radiance})
      .parameter("scale", &EnvironmentParameters::scale,
                 {.doc = "Multiplies the light.", .range = schema::non_negative})
      .parameter("rotate", &EnvironmentParameters::rotate,
                 {.doc = "Turns the picture about z.", .unit = Unit::degrees});
  return node_kind(std::move(d), [](EnvironmentParameters&& e, const Context& context) {
    if (e.file && e.color) context.fail("takes either 'file' or 'color', not both");
    if (e.file) return light_node(ImageEnvironment{e.file->path, e.scale, e.rotate}, context);
    const Spectrum color = e.color.value_or(Spectrum::illuminant({1, 1, 1}));
    return light_node(ConstantEnvironment{color.scaled(static_cast<float>(e.scale))}, context);
  });
}

}  // namespace

std::vector<NodeKind> environment_kinds() {
  return {environment()};
}

}  // namespace lapidary::description
