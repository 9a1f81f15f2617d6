#include "import/mtl_texture.h"

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary::import {
namespace {

using texture::Arithmetic;
using texture::Texture;
using texture::TexturePtr;

PictureOptions picture_options(const MtlTextureOptions& options, bool as_number) {
  if (!as_number) return {};
  const PictureChannel channel = options.scalar_channel == 'g'   ? PictureChannel::green
                                 : options.scalar_channel == 'b' ? PictureChannel::blue
                                 : options.scalar_channel == 'm' ? PictureChannel::alpha
                                                                 : PictureChannel::red;
  return {.channel = channel};
}

/// (u, v) of the picture are those of the surface, scaled, then moved.
TexturePtr placed(TexturePtr picture, const MtlTextureOptions& options) {
  const auto [sx, sy] = options.scale;
  const auto [ox, oy] = options.offset;
  if (sx == 1.0 && sy == 1.0 && ox == 0.0 && oy == 0.0) return picture;
  if (sx == 0.0 || sy == 0.0) return picture;
  const Transform picture_from_surface =
      Transform::translation({ox, oy, 0}) * Transform::scaling({sx, sy, 1});
  TexturePtr there = moved(*picture, picture_from_surface.inverse());
  return there ? there : picture;
}

TexturePtr reckoned(Arithmetic::Operation operation, TexturePtr texture, double number) {
  return std::make_shared<const Texture>(
      Arithmetic{operation, {texture::Color(std::move(texture)), number}});
}

TexturePtr adjusted(TexturePtr texture, const MtlTextureOptions& options) {
  using Operation = Arithmetic::Operation;
  if (options.gain != 1.0)
    texture = reckoned(Operation::multiply, std::move(texture), options.gain);
  if (options.base != 0.0) texture = reckoned(Operation::add, std::move(texture), options.base);
  return texture;
}

}  // namespace

MtlTextures::MtlTextures(const MtlMaterial& material, const MtlReading& reading)
    : material_(material), reading_(reading), used_(material.textures.size()) {}

TexturePtr MtlTextures::color(MtlChannel channel) {
  return read(channel, false);
}

TexturePtr MtlTextures::number(MtlChannel channel) {
  return read(channel, true);
}

TexturePtr MtlTextures::read(MtlChannel channel, bool as_number) {
  if (!reading_.images) return nullptr;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    const MtlTexture& stated = material_.textures[i];
    if (stated.channel != channel) continue;
    used_[i] = true;
    const auto folder = std::filesystem::path(stated.where.file).parent_path();
    const FoundFile file = find_file(folder, stated.stated, reading_.allow);
    const auto warn = [&](const std::string& problem) {
      if (!reading_.warnings) return;
      reading_.warnings->add(stated.where,
                             fmt::format("texture '{}' of material '{}' {}; it is left out",
                                         stated.stated, material_.name, problem));
    };
    if (file.status != FoundFile::Status::found) {
      warn(file.status == FoundFile::Status::missing ? "is not there" : "may not be read");
      return nullptr;
    }
    try {
      texture::Picture picture;
      picture.pyramid =
          reading_.images->read(file.path, picture_options(stated.options, as_number));
      if (stated.options.clamp) picture.wrap = texture::Wrap::clamp;
      const auto texture = std::make_shared<const Texture>(std::move(picture));
      return adjusted(placed(texture, stated.options), stated.options);
    } catch (const Error& error) {
      warn(error.problem());
      return nullptr;
    }
  }
  return nullptr;
}

void MtlTextures::warn_of_the_rest() const {
  std::size_t rest = 0;
  for (const bool used : used_) rest += used ? 0 : 1;
  if (!reading_.warnings || rest == 0) return;
  reading_.warnings->add(
      material_.where,
      fmt::format("material '{}': {} of its textures {} left out, there is nothing for {} in the "
                  "materials of this version",
                  material_.name, rest, rest == 1 ? "is" : "are", rest == 1 ? "it" : "them"));
}

}  // namespace lapidary::import
