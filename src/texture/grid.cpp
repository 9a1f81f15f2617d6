#include "texture/grid.h"

#include "texture/lattice.h"
#include "texture/periodic.h"

namespace lapidary::texture {
namespace {

double brick_shade(std::uint32_t column, std::uint32_t course, std::uint32_t seed) {
  return static_cast<double>(lattice_hash(column, course, 0, seed)) * 0x1p-32;
}

}  // namespace

double line_share(const Grid& grid, const Place& place) {
  const Vec3d width = box_of(place);
  const double half = 0.5 * grid.width;
  return 1.0 -
         (1.0 - mean_line(place.p.x, width.x, half)) * (1.0 - mean_line(place.p.y, width.y, half));
}

BrickLook brick_look(const Bricks& bricks, const Place& place) {
  const Vec3d box = box_of(place);
  const double x = place.p.x / bricks.size.x, y = place.p.y / bricks.size.y;
  const double width = box.x / bricks.size.x, height = box.y / bricks.size.y;
  const double half_x = 0.5 * bricks.joint / bricks.size.x;
  const double half_y = 0.5 * bricks.joint / bricks.size.y;
  const auto upright_joints = [&](double course) {
    const double moved = std::fmod(course, 2.0) == 0.0 ? x : x - bricks.offset;
    return mean_line(moved, width, half_x);
  };
  const double course = std::floor(y);
  double upright = upright_joints(course);
  // Tall footprints see two kinds of courses.
  if (height > 1.0) upright += (0.5 - 0.5 / height) * (upright_joints(course + 1.0) - upright);
  const double flat = mean_line(y, height, half_y);
  const double column = std::floor(std::fmod(course, 2.0) == 0.0 ? x : x - bricks.offset);
  const LatticePoint brick = lattice_point({column, course, 0.0});
  const double own = brick_shade(brick.cell[0], brick.cell[1], bricks.seed);
  const double seen = std::min(1.0, std::max(width, height));
  return {1.0 - (1.0 - upright) * (1.0 - flat), own + seen * (0.5 - own)};
}

double value(const Bricks& bricks, const Lookup& lookup) {
  if (bricks.colors.origin == Ramp::Origin::stated) {
    return static_cast<double>(luminance(color(bricks, RgbPalette{}, lookup)));
  }
  return mapped(bricks.mapping, lookup,
                [&](const Place& place) { return 1.0 - brick_look(bricks, place).mortar; });
}

}  // namespace lapidary::texture
