#include "inspect/overlap.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "inspect/measure.h"
#include "objects.h"

namespace lapidary::inspect {
namespace {

std::vector<Overlap> overlaps_of(const std::vector<description::ObjectPtr>& objects) {
  std::vector<Body> bodies;
  description::for_each_leaf(objects, [&](const description::Leaf& leaf) {
    bodies.push_back({&leaf.object, leaf.world_from_object, measure(leaf).bounds, bodies.size()});
  });
  const OverlapSearch search = find_overlaps(bodies);
  EXPECT_TRUE(search.complete);
  return search.overlaps;
}

bool overlap(const description::ObjectPtr& a, const description::ObjectPtr& b) {
  return !overlaps_of({a, b}).empty();
}

const Transform up_by_one = Transform::translation({0, 0, 1});

TEST(Overlap, TouchingIsNotOverlapping) {
  const auto ground = make_object(geometry::HalfSpace{});
  EXPECT_FALSE(overlap(ground, make_object(geometry::Sphere{}, up_by_one)));
  EXPECT_FALSE(overlap(make_object(geometry::Box{}), make_object(geometry::Box{}, up_by_one)));
  EXPECT_FALSE(
      overlap(make_object(shared(cube_mesh())), make_object(shared(cube_mesh()), up_by_one)));
}

TEST(Overlap, SinkingInIs) {
  const auto ground = make_object(geometry::HalfSpace{});
  const auto cube = make_object(shared(cube_mesh()));
  const Transform sunk = Transform::translation({0, 0, 0.9});
  EXPECT_TRUE(overlap(ground, make_object(geometry::Sphere{}, sunk)));
  EXPECT_TRUE(overlap(make_object(geometry::Box{}), make_object(geometry::Box{}, sunk)));
  EXPECT_TRUE(overlap(cube, make_object(geometry::Box{}, sunk)));
  EXPECT_TRUE(overlap(cube, make_object(shared(cube_mesh()), sunk)));
}

TEST(Overlap, OneInsideTheOtherIs) {
  const auto pea = make_object(geometry::Sphere{{}, 0.1});
  EXPECT_TRUE(overlap(make_object(geometry::Sphere{{}, 1}), pea));
  EXPECT_TRUE(overlap(make_object(shared(cube_mesh())), pea));
}

TEST(Overlap, MirroredMeshesKeepTheirInside) {
  EXPECT_TRUE(overlap(make_object(shared(cube_mesh()), Transform::scaling({1, 1, -1})),
                      make_object(geometry::Sphere{{}, 0.1})));
}

TEST(Overlap, BoxesThatCrossWhileBodiesDoNotAreFine) {
  // Two thin rods side by side on a diagonal: their bounding boxes are all but the same.
  const auto rod = [](double offset) {
    return make_object(geometry::Cylinder{{offset, 0, 0}, {5 + offset, 5, 5}, 0.1});
  };
  EXPECT_FALSE(overlap(rod(0), rod(0.5)));
}

TEST(Overlap, AgreesWithTheDistanceOfRandomSpheres) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-3, 3), size(0.3, 1.2);
  std::vector<geometry::Sphere> spheres;
  std::vector<description::ObjectPtr> objects;
  for (int i = 0; i < 40; ++i) {
    spheres.push_back({{place(random), place(random), place(random)}, size(random)});
    objects.push_back(make_object(spheres.back()));
  }
  std::vector<Overlap> expected;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    for (std::size_t j = i + 1; j < spheres.size(); ++j) {
      const double gap =
          length(spheres[i].center - spheres[j].center) - spheres[i].radius - spheres[j].radius;
      if (gap < 0) expected.push_back({i, j});
    }
  }
  EXPECT_GT(expected.size(), 10u);
  // A sliver may be missed, but nothing may be made up.
  const std::vector<Overlap> found = overlaps_of(objects);
  for (const Overlap& o : found) EXPECT_EQ(std::ranges::count(expected, o), 1);
  EXPECT_GE(10 * found.size(), 9 * expected.size());
}

}  // namespace
}  // namespace lapidary::inspect
