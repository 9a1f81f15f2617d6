#include "import/image_node.h"

#include <fmt/format.h>

#include "description/texture_parameters.h"

namespace lapidary::schema {

template <>
struct EnumNames<import::PictureSpace> {
  static constexpr std::array<std::pair<std::string_view, import::PictureSpace>, 3> names{
      {{"automatic", import::PictureSpace::automatic},
       {"srgb", import::PictureSpace::srgb},
       {"linear", import::PictureSpace::linear}}};
};

template <>
struct EnumNames<import::PictureChannel> {
  static constexpr std::array<std::pair<std::string_view, import::PictureChannel>, 5> names{
      {{"color", import::PictureChannel::color},
       {"red", import::PictureChannel::red},
       {"green", import::PictureChannel::green},
       {"blue", import::PictureChannel::blue},
       {"alpha", import::PictureChannel::alpha}}};
};

template <>
struct EnumNames<texture::Wrap> {
  static constexpr std::array<std::pair<std::string_view, texture::Wrap>, 4> names{
      {{"repeat", texture::Wrap::repeat},
       {"mirror", texture::Wrap::mirror},
       {"clamp", texture::Wrap::clamp},
       {"black", texture::Wrap::black}}};
};

template <>
struct EnumNames<texture::Filter> {
  static constexpr std::array<std::pair<std::string_view, texture::Filter>, 2> names{
      {{"smooth", texture::Filter::smooth}, {"nearest", texture::Filter::nearest}}};
};

}  // namespace lapidary::schema

namespace lapidary::import {
namespace {

using schema::Context;
using schema::Declaration;

struct ImageParameters : texture::Picture, PictureOptions {
  schema::InputFile file;
};

/// What is wrong with the file, where the scene names it.
std::shared_ptr<const texture::Pyramid> read(const ImageParameters& image, ImageFiles& images,
                                             InputFiles* files, const Context& context) {
  try {
    return images.read(image.file.path, image, files);
  } catch (const Error& error) {
    throw context.at("file").error(fmt::format("{} {}", error.where().file, error.problem()),
                                   error.hint());
  }
}

Declaration<ImageParameters> declare_image() {
  using I = ImageParameters;
  Declaration<I> d(
      {.name = "image",
       .doc = "A picture, in the unit square of (u, v) with (0, 0) at its lower left corner.",
       .section = "textures",
       .examples = {"image \"wood.jpg\"", "image { \"wood.jpg\", mapping = \"box\" }:scale(0.5)",
                    "image { \"wood.jpg\", channel = \"red\", wrap = \"mirror\" }"}});
  d.parameter("file", &I::file,
              {.doc = "A PNG, JPEG, Radiance (.hdr) or OpenEXR file.",
               .need = schema::Need::required,
               .shorthand = schema::Shorthand::yes})
      .parameter("color_space", &PictureOptions::space,
                 {.doc = "What its numbers mean; by itself sRGB signals in PNG and JPEG, linear "
                         "light in others, and plain numbers where a channel is taken."})
      .parameter("channel", &PictureOptions::channel,
                 {.doc = "The color, or one channel as a number."})
      .parameter("wrap", &I::wrap, {.doc = "What is beside the unit square."})
      .parameter("filter", &I::filter,
                 {.doc = "Whether the colors between its pixels go smoothly or in steps."});
  description::declare_mapping(d);
  return d;
}

}  // namespace

schema::NodeKind image_kind(ImageFiles& images, InputFiles* files) {
  const auto make = [&images, files](ImageParameters&& image, const Context& context) {
    const std::size_t before = images.bytes();
    image.pyramid = read(image, images, files, context);
    return description::texture_node(texture::Picture(std::move(image)), context,
                                     images.bytes() - before);
  };
  return node_kind(declare_image(), make);
}

}  // namespace lapidary::import
