#include "import/image_file.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "image/image_io.h"
#include "spectrum/color.h"

namespace lapidary::import {
namespace {

using image::Image;

image::ReadOptions reading(const PictureOptions& options) {
  const bool plain =
      options.space != PictureSpace::automatic || options.channel != PictureChannel::color;
  return {
      .color_space = plain ? image::ColorSpace::linear : image::ColorSpace::automatic,
      .alpha = options.channel == PictureChannel::alpha ? image::Alpha::keep : image::Alpha::drop};
}

Image one_channel(const Image& picture, PictureChannel channel) {
  const auto from =
      static_cast<std::size_t>(channel) - static_cast<std::size_t>(PictureChannel::red);
  const auto step = static_cast<std::size_t>(picture.channels);
  Image one(picture.width, picture.height, 1);
  for (std::size_t i = 0; i < one.pixels.size(); ++i)
    one.pixels[i] = picture.pixels[i * step + from];
  return one;
}

void check_finite(const Image& picture, const std::filesystem::path& file) {
  if (image::count_non_finite(picture) == 0) return;
  const auto channels = static_cast<std::size_t>(picture.channels);
  std::size_t i = 0;
  while (std::isfinite(picture.pixels[i])) ++i;
  const std::size_t pixel = i / channels, width = static_cast<std::size_t>(picture.width);
  throw file_error(
      file.string(),
      fmt::format("pixel ({}, {}) is not a finite number", pixel % width, pixel / width),
      "a texture needs a value everywhere");
}

Image picture_of(const std::filesystem::path& file, const PictureOptions& options,
                 InputFiles* files) {
  image::ReadOptions how = reading(options);
  how.files = files;
  Image picture = image::read_image(file, how);
  if (options.channel != PictureChannel::color) picture = one_channel(picture, options.channel);
  check_finite(picture, file);
  if (options.space == PictureSpace::srgb) {
    for (float& v : picture.pixels) v = srgb_decode(v);
  }
  return picture;
}

}  // namespace

std::shared_ptr<const texture::Pyramid> ImageFiles::read(const std::filesystem::path& file,
                                                         const PictureOptions& options,
                                                         InputFiles* files) {
  Entry& entry = read_[{file, options}];
  if (!entry.pyramid) {
    const std::size_t before = files != nullptr ? files->noted() : 0;
    entry.pyramid = std::make_shared<const texture::Pyramid>(picture_of(file, options, files));
    if (files != nullptr) entry.notes = files->noted_since(before);
  } else if (files != nullptr) {
    files->note_again(entry.notes);
  }
  if (!std::exchange(entry.is_used, true)) bytes_ += entry.pyramid->bytes();
  return entry.pyramid;
}

void ImageFiles::begin_scene() {
  std::erase_if(read_, [](const auto& read) { return !read.second.is_used; });
  for (auto& [key, entry] : read_) entry.is_used = false;
  bytes_ = 0;
}

}  // namespace lapidary::import
