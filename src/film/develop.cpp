#include "film/develop.h"

#include <array>
#include <cstddef>
#include <string>

namespace lapidary::film {
namespace {

/// `value(x, y)` for all pixels, row by row.
template <typename T, typename Value>
std::vector<T> samples(const Film& film, Value value) {
  std::vector<T> all;
  all.reserve(static_cast<std::size_t>(film.width()) * static_cast<std::size_t>(film.height()));
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) all.push_back(value(x, y));
  }
  return all;
}

using image::Precision;

/// Adds three channels that are called `prefix` plus R, G and B.
void add_rgb(image::LayeredImage& picture, const Film& film, const std::string& prefix,
             Rgb (Film::*layer)(int, int) const, Precision precision) {
  constexpr std::array<float Rgb::*, 3> components = {&Rgb::r, &Rgb::g, &Rgb::b};
  constexpr std::array<const char*, 3> names = {"R", "G", "B"};
  for (std::size_t i = 0; i < 3; ++i) {
    picture.channels.push_back(
        {prefix + names[i],
         samples<float>(film, [&](int x, int y) { return (film.*layer)(x, y).*components[i]; }),
         precision});
  }
}

void add_normal(image::LayeredImage& picture, const Film& film) {
  constexpr std::array<const char*, 3> names = {"normal.X", "normal.Y", "normal.Z"};
  for (std::size_t i = 0; i < 3; ++i) {
    picture.channels.push_back(
        {names[i], samples<float>(film, [&](int x, int y) { return film.normal(x, y)[i]; }),
         Precision::half});
  }
}

}  // namespace

image::LayeredImage develop(const Film& film) {
  image::LayeredImage picture;
  picture.width = film.width();
  picture.height = film.height();
  add_rgb(picture, film, "", &Film::beauty, Precision::full);
  if (film.layers() == Layers::beauty) return picture;
  add_rgb(picture, film, "albedo.", &Film::albedo, Precision::half);
  add_normal(picture, film);
  picture.channels.push_back(
      {"depth.Z", samples<float>(film, [&](int x, int y) { return film.depth(x, y); })});
  picture.channels.push_back(
      {"id.object", samples<std::uint32_t>(film, [&](int x, int y) { return film.object(x, y); })});
  add_rgb(picture, film, "variance.", &Film::variance, Precision::full);
  return picture;
}

}  // namespace lapidary::film
