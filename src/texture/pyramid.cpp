#include "texture/pyramid.h"

#include <algorithm>
#include <array>

namespace lapidary::texture {
namespace {

using image::Image;
using Vec2i = Vec2<int>;

bool is_grey(const Image& picture) {
  for (std::size_t i = 0; i + 2 < picture.pixels.size(); i += 3) {
    if (picture.pixels[i] != picture.pixels[i + 1] || picture.pixels[i] != picture.pixels[i + 2]) {
      return false;
    }
  }
  return true;
}

Image first_channel(const Image& picture) {
  Image grey(picture.width, picture.height, 1);
  for (std::size_t i = 0; i < grey.pixels.size(); ++i) grey.pixels[i] = picture.pixels[3 * i];
  return grey;
}

/// Which pixels of a row or column one of half as many covers, and how much of each: at most three.
struct Cover {
  int first = 0;
  int count = 0;
  std::array<float, 4> weight{};
};

std::vector<Cover> covers(int from, int to) {
  std::vector<Cover> all(static_cast<std::size_t>(to));
  const double size = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    Cover& cover = all[static_cast<std::size_t>(i)];
    const double begin = i * size, end = i + 1 == to ? from : (i + 1) * size;
    cover.first = static_cast<int>(begin);
    for (int k = cover.first; k < from && k < end && cover.count < 4; ++k) {
      const double part = std::min(end, k + 1.0) - std::max(begin, static_cast<double>(k));
      cover.weight[static_cast<std::size_t>(cover.count++)] = static_cast<float>(part / size);
    }
  }
  return all;
}

Image halved(const Image& picture, Vec2i size) {
  Image half(size.x, size.y, picture.channels);
  const auto columns = covers(picture.width, half.width);
  const auto rows = covers(picture.height, half.height);
  for (int y = 0; y < half.height; ++y) {
    const Cover& row = rows[static_cast<std::size_t>(y)];
    for (int x = 0; x < half.width; ++x) {
      const Cover& column = columns[static_cast<std::size_t>(x)];
      const auto mean = half.pixel(x, y);
      for (int j = 0; j < row.count; ++j) {
        for (int i = 0; i < column.count; ++i) {
          const float weight =
              row.weight[static_cast<std::size_t>(j)] * column.weight[static_cast<std::size_t>(i)];
          const auto part = picture.pixel(column.first + i, row.first + j);
          for (std::size_t c = 0; c < mean.size(); ++c) mean[c] += weight * part[c];
        }
      }
    }
  }
  return half;
}

}  // namespace

std::vector<Pyramid::Level> Pyramid::levels_of(const Image& picture) {
  std::vector<Level> levels{{picture.width, picture.height, 0}};
  for (;;) {
    const Level last = levels.back();
    if (last.width == 1 && last.height == 1) return levels;
    levels.push_back(
        {std::max(1, last.width / 2), std::max(1, last.height / 2), last.first + last.room()});
  }
}

Pyramid::Pyramid(const Image& picture)
    : levels_(levels_of(picture)),
      channels_(picture.channels == 3 && !is_grey(picture) ? 3 : 1),
      texels_(picture.pixels, (levels_.back().first + levels_.back().room()) *
                                  static_cast<std::size_t>(channels_)) {
  Image smaller;
  const Image* image = &picture;
  if (channels_ != picture.channels) image = &(smaller = first_channel(picture));
  for (const Level& level : levels_) {
    if (level.first > 0) {
      Image next = halved(*image, {level.width, level.height});
      smaller = std::move(next);
      image = &smaller;
    }
    append(*image, level);
  }
}

void Pyramid::append(const Image& picture, const Level& level) {
  const auto channels = static_cast<std::size_t>(channels_);
  const auto side = static_cast<int>(Level::side);
  std::vector<float> squares(level.squares_across() * Level::area * channels);
  for (int top = 0; top < picture.height; top += side) {
    for (int y = top; y < std::min(top + side, picture.height); ++y) {
      for (int x = 0; x < picture.width; x += side) {
        const auto count = static_cast<std::size_t>(std::min(side, picture.width - x));
        const std::size_t place = level.column(x) - level.first + level.row(y - top);
        std::copy_n(picture.pixel(x, y).data(), count * channels, &squares[place * channels]);
      }
    }
    texels_.append(squares);
  }
}

std::size_t Pyramid::bytes() const {
  return sizeof *this + levels_.capacity() * sizeof(Level) + texels_.bytes();
}

}  // namespace lapidary::texture
