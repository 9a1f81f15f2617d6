// Frames of an animation: seconds to build the scene of a second frame, of a million operands or
// so, that was made anew with the same in it, or with one body in another place; all threads, wall
// time. What the first one takes stands beside it.

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "description/object.h"
#include "report.h"
#include "scene/build.h"

namespace {

using namespace lapidary;
using namespace lapidary::bench;
using description::ObjectPtr;
using description::SceneDescription;
using description::SetOperation;

constexpr int columns = 1250, rows = 800;
constexpr double side = 0.0125;

ObjectPtr solid(const geometry::Solid& shape, description::MaterialPtr worn = nullptr) {
  description::Object object;
  object.content = shape;
  object.material = std::move(worn);
  return std::make_shared<const description::Object>(std::move(object));
}

ObjectPtr hole(int column, int row) {
  const double x = (column + 0.5) * side, y = (row + 0.5) * side;
  return solid(geometry::Cylinder{{x, y, 0}, {x, y, 0.5}, 0.35 * side});
}

/// A part of a plate, with its holes.
ObjectPtr tile(int first_column, int first_row, int width, int height) {
  const Vec3d corner{first_column * side, first_row * side, 0};
  std::vector<ObjectPtr> operands{solid(
      geometry::Box{corner, corner + Vec3d{0.999 * width * side, 0.999 * height * side, 0.5}})};
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) operands.push_back(hole(first_column + i, first_row + j));
  }
  return make_combination(SetOperation::subtract, std::move(operands), {});
}

std::vector<ObjectPtr> one_plate() {
  return {tile(0, 0, columns, rows)};
}

std::vector<ObjectPtr> many_tiles() {
  std::vector<ObjectPtr> tiles;
  for (int j = 0; j < rows; j += 10) {
    for (int i = 0; i < columns; i += 10) tiles.push_back(tile(i, j, 10, 10));
  }
  return tiles;
}

std::vector<ObjectPtr> lone_bodies() {
  std::vector<ObjectPtr> bodies;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) bodies.push_back(hole(i, j));
  }
  return bodies;
}

/// Cut by 57 planes, spread over all directions as the seeds of a sunflower are.
ObjectPtr stone(Vec3d middle) {
  constexpr int planes = 57;
  const double golden = pi * (3 - std::sqrt(5.0));
  std::vector<ObjectPtr> operands;
  for (int i = 0; i < planes; ++i) {
    const double z = 1 - (2 * i + 1.0) / planes, r = std::sqrt(1 - z * z);
    const Vec3d n{r * std::cos(i * golden), r * std::sin(i * golden), z};
    operands.push_back(solid(geometry::HalfSpace{middle + n * 0.04, n}));
  }
  return make_combination(SetOperation::intersect, std::move(operands), {});
}

std::vector<ObjectPtr> stones() {
  std::vector<ObjectPtr> bodies;
  for (int j = 0; j < 100; ++j) {
    for (int i = 0; i < 150; ++i) bodies.push_back(stone({0.1 * i, 0.1 * j, 0}));
  }
  return bodies;
}

/// `ball` is where one more body is.
SceneDescription frame(std::vector<ObjectPtr> objects, double ball) {
  SceneDescription scene;
  scene.objects = std::move(objects);
  scene.objects.push_back(solid(geometry::Sphere{{ball, 5, 1}, 0.4}));
  description::Perspective camera;
  camera.view = {{8, -8, 13}, {8, 5, 0}, {0, 0, 1}};
  scene.camera.emplace(description::Camera{camera, {}});
  return scene;
}

struct Targets {
  std::string_view same, one_moved;
};

void measure(const std::string& name, std::vector<ObjectPtr> (*objects)(), const Targets& targets) {
  ThreadPool pool;
  WarningLog warnings;
  scene::Kept kept;
  const auto build_seconds = [&](double ball) {
    const SceneDescription description = frame(objects(), ball);
    std::optional<scene::Scene> scene;
    return seconds([&] {
      scene.emplace(scene::build(
          description,
          {.size = description.render.size, .pool = pool, .warnings = warnings, .kept = &kept}));
    });
  };
  const auto best_of = [&](int runs, auto&& next) {
    double best = infinity;
    for (int run = 0; run < runs; ++run) best = std::min(best, next(run));
    return best;
  };
  report("frames." + name + ".first_seconds", build_seconds(0), "s");
  report("frames." + name + ".same_seconds", best_of(3, [&](int) { return build_seconds(0); }), "s",
         targets.same);
  report("frames." + name + ".one_moved_seconds",
         best_of(3, [&](int run) { return build_seconds(1 + run); }), "s", targets.one_moved);
}

}  // namespace

int main() {
  constexpr Targets targets{"<=0.35", "<=0.6"};
  measure("plate", one_plate, targets);
  measure("tiles", many_tiles, targets);
  // That each is an object of the scene takes as long as that it is an operand.
  measure("bodies", lone_bodies, {"-", "-"});
  // 855,000 planes, which are cut into polyhedra.
  measure("stones", stones, {"-", "-"});
  return 0;
}
