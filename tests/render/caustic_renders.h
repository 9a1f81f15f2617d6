#pragma once

#include <vector>

#include "render/block.h"
#include "scene/tiny_scene.h"
#include "support/statistics.h"

namespace lapidary::test {

/// How small pictures of caustics are rendered, several of them. Those of different seeds are
/// independent; blocks of passes of one seed share what they have learned, which costs as much as
/// many passes, and points that are spread over all of them: their mean is better than it looks.
struct SmallRenders {
  transport::CausticMethod method = transport::CausticMethod::automatic;
  int depth = 6;
  int side = 12;    ///< of the picture, pixels
  int regions = 1;  ///< along each side
  int seeds = 8;
  std::uint32_t blocks = 1;   ///< of each seed
  std::uint32_t passes = 64;  ///< of each block
  double photon_radius = transport::PhotonSettings().first_radius;
};

/// Of green, row by row.
inline std::vector<double> sums_of_regions(const film::Film& film, int regions) {
  std::vector<double> sums(static_cast<std::size_t>(regions * regions));
  const int width = film.width() / regions;
  for (int y = 0; y < film.height(); ++y) {
    for (int x = 0; x < film.width(); ++x) {
      sums[static_cast<std::size_t>(y / width * regions + x / width)] +=
          static_cast<double>(film.beauty(x, y).g);
    }
  }
  return sums;
}

/// Mean of the green of each square region, row by row, over all blocks.
inline std::vector<RunningMean> brightness_of_regions(const scene::Scene& scene,
                                                      const SmallRenders& how) {
  ThreadPool pool(2);
  const int side = how.side, width = side / how.regions;
  std::vector<RunningMean> means(static_cast<std::size_t>(how.regions * how.regions));
  for (int seed = 1; seed <= how.seeds; ++seed) {
    render::SampleSettings settings{{.max_depth = how.depth, .caustics = how.method},
                                    FilterSampler(FilterKind::box, 0.5),
                                    static_cast<std::uint64_t>(seed)};
    settings.photons.first_radius = how.photon_radius;
    const render::BlockRenderer renderer(scene, settings, {side, side}, pool);
    for (std::uint32_t block = 0; block < how.blocks; ++block) {
      film::Film film({.width = side, .height = side, .layers = film::Layers::beauty});
      renderer.render({block * how.passes, (block + 1) * how.passes}, film, pool);
      const std::vector<double> sums = sums_of_regions(film, how.regions);
      for (std::size_t i = 0; i < sums.size(); ++i) means[i].add(sums[i] / (width * width));
    }
  }
  return means;
}

/// The same of the whole picture.
inline RunningMean brightness(const scene::Scene& scene, const SmallRenders& how) {
  return brightness_of_regions(scene, how).front();
}

/// A lens of this glass over a matte floor, and another ball that only stands by.
inline TinyScene lens_over_floor(description::MaterialPtr worn) {
  TinyScene tiny;
  tiny.add(geometry::Rectangle{{-3, -3, 0}, {6, 0, 0}, {0, 6, 0}}, matte(0.6));
  tiny.add(geometry::Sphere{{}, 1.0}, std::move(worn),
           Transform::translation({0, 0, 1}) * Transform::scaling({0.6, 0.6, 0.25}));
  tiny.add(geometry::Sphere{{0.9, 0.4, 0.3}, 0.3}, matte(0.5));
  // The floor under the lens, from the side.
  tiny.look({0, -3, 1.2}, {0, 0, 0}, 30.0);
  tiny.description.render.size = {12, 12};  // square
  return tiny;
}

}  // namespace lapidary::test
