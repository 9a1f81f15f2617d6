#include "import/mtl_texture.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"

namespace lapidary::import {
namespace {

using texture::Arithmetic;
using texture::Texture;
using texture::TexturePtr;

PictureChannel scalar_channel(char letter) {
  switch (letter) {
    case 'g':
      return PictureChannel::green;
    case 'b':
      return PictureChannel::blue;
    case 'm':
      return PictureChannel::alpha;
    default:
      return PictureChannel::red;
  }
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
  return read(take(channel), {});
}

TexturePtr MtlTextures::number(MtlChannel channel) {
  const MtlTexture* stated = take(channel);
  if (!stated) return nullptr;
  const bool of_colors =
      channel == MtlChannel::dissolve &&
      std::any_of(material_.textures.begin(), material_.textures.end(),
                  [&](const MtlTexture& other) {
                    return other.channel == MtlChannel::diffuse && other.file == stated->file;
                  });
  return read(stated, {.channel = of_colors ? PictureChannel::alpha
                                            : scalar_channel(stated->options.scalar_channel)});
}

TexturePtr MtlTextures::height() {
  const MtlTexture* stated = take(MtlChannel::bump);
  TexturePtr texture =
      stated ? read(stated, {.channel = scalar_channel(stated->options.scalar_channel)}) : nullptr;
  const double height = stated ? stated->options.bump_multiplier.value_or(1.0) : 1.0;
  if (!texture || height == 1.0) return texture;
  return reckoned(Arithmetic::Operation::multiply, std::move(texture), height);
}

TexturePtr MtlTextures::normals() {
  return read(take(MtlChannel::normal), {.space = PictureSpace::linear});
}

const MtlTexture* MtlTextures::take(MtlChannel channel) {
  for (std::size_t i = 0; i < used_.size() && reading_.images; ++i) {
    if (material_.textures[i].channel != channel) continue;
    used_[i] = true;
    return &material_.textures[i];
  }
  return nullptr;
}

TexturePtr MtlTextures::read(const MtlTexture* stated, const PictureOptions& options) const {
  if (!stated) return nullptr;
  const auto folder = std::filesystem::path(stated->where.file).parent_path();
  const FoundFile file = find_file(folder, stated->stated, reading_.allow, reading_.files);
  if (file.status != FoundFile::Status::found) {
    const bool missing = file.status == FoundFile::Status::missing;
    warn(*stated, missing ? "is not there" : "may not be read");
    return nullptr;
  }
  try {
    texture::Picture picture;
    picture.pyramid = reading_.images->read(file.path, options, reading_.files);
    if (stated->options.clamp) picture.wrap = texture::Wrap::clamp;
    auto texture = std::make_shared<const Texture>(std::move(picture));
    return adjusted(placed(std::move(texture), stated->options), stated->options);
  } catch (const Error& error) {
    warn(*stated, error.problem());
    return nullptr;
  }
}

void MtlTextures::warn(const MtlTexture& stated, std::string_view problem) const {
  if (!reading_.warnings) return;
  reading_.warnings->add(
      stated.where, fmt::format("texture '{}' of material '{}' {}; it is left out", stated.stated,
                                material_.name, problem));
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
