// Faces that are found of planes, in hostile places and orders.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/polyhedron.h"
#include "support/random.h"

namespace lapidary::geometry {
namespace {

using test::Random;

/// A bounded one about the origin, of planes up to `size` from it that hit it more or less
/// squarely.
std::vector<HalfSpace> bounded_planes(Random& random, double size) {
  std::vector<HalfSpace> planes;
  for (std::size_t i = 0; i < 6; ++i) {
    Vec3d n;
    n[i % 3] = i < 3 ? 1 : -1;
    planes.push_back({n * size, n});
  }
  for (std::size_t more = random.index(20); more > 0; --more) {
    const Vec3d n = random.direction();
    planes.push_back({n * size * random.uniform(0.2, 1.2), n * random.magnitude(-3, 3)});
  }
  return planes;
}

// Corners where many planes meet are decided in high precision, whatever comes first.
TEST(PolyhedronFaces, IsTheSameInWhateverOrderItsPlanesCome) {
  Random random(65);
  for (int i = 0; i < 300; ++i) {
    std::vector<HalfSpace> planes = bounded_planes(random, 1);
    // Through a corner of the cube, and through an edge of it.
    planes.push_back({{1, 1, 1}, {1, random.uniform(0, 1), random.uniform(0, 1)}});
    planes.push_back({{1, 1, 0}, {1, random.uniform(0, 1), 0}});
    const Polyhedron stated = *intersection(planes);
    for (std::size_t k = planes.size(); k > 1; --k) {
      std::swap(planes[k - 1], planes[random.index(k)]);
    }
    const Polyhedron shuffled = *intersection(planes);
    ASSERT_NEAR(area(shuffled), area(stated), 1e-13 * area(stated));
    ASSERT_NEAR(shuffled.volume(), stated.volume(), 1e-13);
    ASSERT_EQ(bounds(shuffled), bounds(stated));
  }
}

// A shift by whole numbers, and of coordinates that have room for it, is exact.
TEST(PolyhedronFaces, CornersAreAsGoodFarFromTheOrigin) {
  Random random(66);
  const Vec3d far{0x1p30, -0x1p29, 0x1p28};
  for (int i = 0; i < 300; ++i) {
    std::vector<HalfSpace> planes = bounded_planes(random, 1);
    for (HalfSpace& h : planes) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        h.point[axis] = std::round(h.point[axis] * 0x1p20) * 0x1p-20;
      }
    }
    const auto near = intersection(planes);
    for (HalfSpace& h : planes) h.point += far;
    const auto shifted = intersection(planes);
    ASSERT_TRUE(near && shifted);
    const Box3d a = bounds(*near), b = bounds(*shifted);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_NEAR(b.min[axis] - far[axis], a.min[axis], 0x1p-20);
      ASSERT_NEAR(b.max[axis] - far[axis], a.max[axis], 0x1p-20);
    }
    ASSERT_NEAR(area(*shifted), area(*near), 1e-5);
  }
}

bool holds(const Box3d& outer, const Box3d& inner) {
  return max(outer.max, inner.max) == outer.max && min(outer.min, inner.min) == outer.min;
}

TEST(PolyhedronFaces, DisplacedBoundsHoldWhateverIsDisplaced) {
  Random random(67);
  for (int i = 0; i < 1000; ++i) {
    std::vector<HalfSpace> planes = bounded_planes(random, random.magnitude(-2, 3));
    // Every third is a needle or a flake.
    if (i % 3 == 0) {
      const Vec3d n = random.direction();
      const double half = random.magnitude(-7, -2);
      planes.push_back({n * half, n});
      planes.push_back({n * -half, -n});
    }
    const auto solid = intersection(planes);
    ASSERT_TRUE(solid);
    const Box3d plain = bounds(*solid);
    const double size = length(plain.max - plain.min), error = size * random.magnitude(-16, -9);
    const Box3d padded = displaced_bounds(*solid, error);
    for (int k = 0; k < 3; ++k) {
      std::vector<HalfSpace> displaced = planes;
      for (HalfSpace& h : displaced) {
        h.point += normalize(h.normal) * error * (k == 0 ? 1 : random.uniform(-1, 1));
      }
      const auto moved = intersection(displaced);
      ASSERT_TRUE(!moved || holds(padded, bounds(*moved))) << i << " " << k;
    }
    ASSERT_TRUE(padded.bounded());
    if (i % 3 != 0) {
      ASSERT_LT(length(padded.max - padded.min), size + 100 * error);
    }
  }
  const Polyhedron slab = *intersection(std::vector<HalfSpace>{{{0, 0, 3}, {0, 0, 1}}});
  EXPECT_EQ(displaced_bounds(slab, 0), bounds(slab));
  EXPECT_GE(displaced_bounds(slab, 0.5).max.z, 3.5);
}

TEST(PolyhedronFaces, ImagesMeasureAsTheirPlanesDo) {
  Random random(68);
  for (int i = 0; i < 200; ++i) {
    const std::vector<HalfSpace> planes = bounded_planes(random, 1);
    const Transform map = Transform::translation(random.direction() * 3.0) *
                          Transform::rotation(random.direction(), random.uniform(0, 2 * pi)) *
                          Transform::scaling({random.uniform(0.5, 2), i % 2 == 0 ? 1.0 : -1.0, 1});
    std::vector<HalfSpace> images;
    for (const HalfSpace& h : planes) {
      images.push_back({map.point(h.point), map.normal(h.normal)});
    }
    const Polyhedron found = image(*intersection(planes), images, map);
    const Polyhedron expected = *intersection(images);
    ASSERT_NEAR(area(found), area(expected), 1e-12 * area(expected));
    ASSERT_NEAR(found.volume(), expected.volume(), 1e-12 * expected.volume());
    ASSERT_LT(length(bounds(found).min - bounds(expected).min), 1e-12);
    ASSERT_LT(length(bounds(found).max - bounds(expected).max), 1e-12);
    const BoundaryPoint b = sample_boundary(found, random.uniform2(), random.uniform());
    ASSERT_NEAR(dot(b.p - images[b.patch].point, b.normal), 0.0, 1e-13);
  }
}

}  // namespace
}  // namespace lapidary::geometry
