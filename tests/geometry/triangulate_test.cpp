#include "geometry/triangulate.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::geometry {
namespace {

using Outline = std::vector<Vec2d>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

double twice_area(Vec2d a, Vec2d b, Vec2d c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double twice_area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2d a = outline[i], b = outline[(i + 1) % outline.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return sum;
}

// By the angles that the edges subtend: independent of any triangulation.
int winding_number(const Outline& outline, Vec2d p) {
  double angle = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2d a = outline[i] - p, b = outline[(i + 1) % outline.size()] - p;
    angle += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
  }
  return static_cast<int>(std::lround(angle / (2 * pi)));
}

// A plane in space as the image of the xy plane.
struct Plane {
  Vec3d origin{0, 0, 0}, u{1, 0, 0}, v{0, 1, 0};
  Vec3d at(Vec2d p) const { return origin + u * p.x + v * p.y; }
};

Plane random_plane(test::Random& random) {
  const Vec3d n = random.direction();
  const Vec3d u = normalize(cross(n, std::abs(n.x) < 0.5 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
  return {random.direction() * 10.0, u, cross(n, u)};
}

struct Cut {
  Triangles triangles;
  Triangulation quality = Triangulation::exact;
};

Cut cut(const Outline& outline, const Plane& plane = {}) {
  std::vector<Vec3d> corners;
  for (const Vec2d p : outline) corners.push_back(plane.at(p));
  Cut result;
  PolygonTriangulator triangulator;
  result.quality = triangulator.triangulate(corners, result.triangles);
  return result;
}

// Each triangle turns like the outline, together they have its area, and random points are inside
// as many triangles as the outline goes round them: so they tile it.
void expect_tiling(const Outline& outline, const Cut& cut, std::uint64_t seed) {
  ASSERT_EQ(cut.triangles.size(), outline.size() - 2);
  EXPECT_EQ(cut.quality, Triangulation::exact);
  const double area = twice_area(outline);
  double sum = 0;
  for (const auto& [a, b, c] : cut.triangles) {
    const double part = twice_area(outline[a], outline[b], outline[c]);
    EXPECT_GE(part, -1e-9 * area) << a << ' ' << b << ' ' << c;
    sum += part;
  }
  EXPECT_NEAR(sum, area, 1e-9 * area);

  Vec2d low = outline[0], high = outline[0];
  for (const Vec2d p : outline) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  test::Random random(seed);
  for (int i = 0; i < 30; ++i) {
    const Vec2d p{random.uniform(low.x, high.x), random.uniform(low.y, high.y)};
    int count = 0;
    for (const auto& [a, b, c] : cut.triangles) {
      count += twice_area(outline[a], outline[b], p) > 0 &&
               twice_area(outline[b], outline[c], p) > 0 &&
               twice_area(outline[c], outline[a], p) > 0;
    }
    EXPECT_EQ(count, winding_number(outline, p)) << p.x << ' ' << p.y;
  }
}

void expect_tiling(const Outline& outline, const Plane& plane = {}, std::uint64_t seed = 1) {
  expect_tiling(outline, cut(outline, plane), seed);
}

Outline star(test::Random& random, std::size_t corners) {
  Outline outline;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(corners);
    const double radius = random.uniform(0.1, 1.0);
    outline.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

// A corridor that winds `turns` times around the origin.
Outline spiral(std::size_t steps, double turns) {
  Outline outline;
  const auto at = [&](std::size_t i, double offset) {
    const double angle = 2 * pi * turns * static_cast<double>(i) / static_cast<double>(steps);
    const double radius = 1 + angle / (2 * pi) + offset;
    return Vec2d{radius * std::cos(angle), radius * std::sin(angle)};
  };
  for (std::size_t i = 0; i <= steps; ++i) outline.push_back(at(i, 0.4));
  for (std::size_t i = steps + 1; i-- > 0;) outline.push_back(at(i, 0.0));
  return outline;
}

Outline comb(std::size_t teeth) {
  Outline outline{{0, -1}, {static_cast<double>(teeth), -1}};
  for (std::size_t i = teeth; i-- > 0;) {
    const auto x = static_cast<double>(i);
    outline.insert(outline.end(), {{x + 0.75, 5}, {x + 0.5, 0}});
  }
  return outline;
}

TEST(Triangulate, KeepsATriangle) {
  const Cut result = cut({{0, 0}, {1, 0}, {0, 1}});
  EXPECT_EQ(result.triangles, (Triangles{{0, 1, 2}}));
}

TEST(Triangulate, TakesTheShorterDiagonalOfAQuad) {
  EXPECT_EQ(cut({{0, 0}, {2, 0}, {3, 1}, {1, 1}}).triangles, (Triangles{{1, 2, 3}, {1, 3, 0}}));
  EXPECT_EQ(cut({{0, 0}, {1, 0}, {1, 1}, {0, 1}}).triangles, (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Triangulate, CutsConcaveQuadsAtTheReflexCorner) {
  const Outline arrow{{0, 0}, {2, 1}, {0, 2}, {0.5, 1}};
  for (std::size_t turn = 0; turn < 4; ++turn) {
    Outline turned = arrow;
    std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn), turned.end());
    expect_tiling(turned);
  }
}

TEST(Triangulate, UsesACornerOnTheStraightEdgeOfAQuad) {
  const Outline outline{{0, 0}, {1, 0}, {2, 0}, {1, 2}};
  const Cut result = cut(outline);
  for (const auto& [a, b, c] : result.triangles) {
    EXPECT_GT(twice_area(outline[a], outline[b], outline[c]), 0);
  }
}

TEST(Triangulate, TilesRandomStarsInRandomPlanes) {
  test::Random random(11);
  for (int i = 0; i < 60; ++i) {
    const Outline outline = star(random, 3 + random.index(40));
    expect_tiling(outline, random_plane(random), static_cast<std::uint64_t>(i));
  }
}

TEST(Triangulate, TilesSpiralsCombsAndLargeStars) {
  test::Random random(12);
  expect_tiling(spiral(100, 3.5), random_plane(random));
  expect_tiling(spiral(1000, 8), random_plane(random));
  expect_tiling(comb(200), random_plane(random));
  expect_tiling(star(random, 2000), random_plane(random));
}

TEST(Triangulate, FollowsTheOutlineWhicheverWayItTurns) {
  const Outline forward{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}};
  const Outline backward(forward.rbegin(), forward.rend());
  const Cut result = cut(backward);
  double sum = 0;
  for (const auto& [a, b, c] : result.triangles) {
    EXPECT_LT(twice_area(backward[a], backward[b], backward[c]), 0);
    sum += twice_area(backward[a], backward[b], backward[c]);
  }
  EXPECT_DOUBLE_EQ(sum, twice_area(backward));
}

TEST(Triangulate, LeavesNoSliverOfAConvexOutlineThatItCanAvoid) {
  Outline outline;
  for (int i = 0; i < 64; ++i) {
    outline.push_back({std::cos(2 * pi * i / 64), std::sin(2 * pi * i / 64)});
  }
  double least = 1;
  for (const auto& [a, b, c] : cut(outline).triangles) {
    least = std::min(least, twice_area(outline[a], outline[b], outline[c]));
  }
  // No triangle is smaller than an ear of the outline itself; a fan's would all be thin.
  EXPECT_NEAR(least, twice_area(outline[0], outline[1], outline[2]), 1e-12);
}

TEST(Triangulate, CutsOutlinesWithCornersOnStraightEdges) {
  Outline outline;
  for (int i = 0; i < 10; ++i) outline.push_back({i * 0.1, 0});
  for (int i = 0; i < 10; ++i) outline.push_back({1, i * 0.1});
  for (int i = 0; i < 10; ++i) outline.push_back({1 - i * 0.1, 1});
  for (int i = 0; i < 10; ++i) outline.push_back({0, 1 - i * 0.1});
  test::Random random(3);
  expect_tiling(outline);
  expect_tiling(outline, random_plane(random));
}

TEST(Triangulate, CutsAroundHolesJoinedByABridge) {
  // A square with two square holes; the bridges run both ways over the same corners.
  const Outline outline{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {1, 1}, {1, 3}, {3, 3},
                        {3, 1}, {5, 5}, {5, 7}, {7, 7}, {7, 5}, {5, 5}, {3, 1}, {1, 1}};
  EXPECT_DOUBLE_EQ(twice_area(outline), 2 * (64 - 4 - 4));
  expect_tiling(outline);
}

TEST(Triangulate, CutsOutlinesThatTouchThemselvesAtACorner) {
  // Two triangles joined at the origin; one with a notch whose tip touches the opposite edge.
  expect_tiling({{0, 0}, {2, -1}, {2, 1}, {0, 0}, {-2, 1}, {-2, -1}});
  expect_tiling({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}});
  // A notch whose tip is the tip of the whole: it leaves through the base of that ear.
  expect_tiling({{0, 0}, {3, 3}, {1, 4}, {0, 0}, {-1, 4}, {-3, 3}});
}

TEST(Triangulate, CutsPetalsThatMeetInOnePoint) {
  for (std::size_t petals = 2; petals < 20; ++petals) {
    Outline outline;
    for (std::size_t i = 0; i < petals; ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(petals);
      const double width = 2 / static_cast<double>(petals);
      outline.insert(outline.end(), {{0, 0},
                                     {std::cos(angle), std::sin(angle)},
                                     {std::cos(angle + width), std::sin(angle + width)}});
    }
    for (std::size_t turn = 0; turn < 3; ++turn) {
      expect_tiling(outline);
      std::rotate(outline.begin(), outline.begin() + 1, outline.end());
    }
  }
}

TEST(Triangulate, CutsOutlinesWithRepeatedCornersAndSpikes) {
  expect_tiling({{0, 0}, {0, 0}, {2, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}});
  expect_tiling({{0, 0}, {2, 0}, {2, 1}, {5, 1}, {2, 1}, {2, 2}, {0, 2}});
}

TEST(Triangulate, CutsStarsWithSpikesAndRepeatedCorners) {
  test::Random random(31);
  for (int i = 0; i < 100; ++i) {
    Outline outline;
    for (const Vec2d p : star(random, 3 + random.index(12))) {
      outline.push_back(p);
      const std::size_t extras = random.index(3);
      for (std::size_t k = 0; k < extras; ++k) {
        if (random.index(2) == 0) outline.push_back({random.uniform(-2, 2), random.uniform(-2, 2)});
        outline.push_back(p);
      }
    }
    expect_tiling(outline, Plane{}, static_cast<std::uint64_t>(i));
  }
}

TEST(Triangulate, SaysThatACrossingOutlineIsForcedAndKeepsItsArea) {
  const Outline pentagram{{0, 1}, {0.6, -0.8}, {-1, 0.3}, {1, 0.3}, {-0.6, -0.8}};
  const Cut result = cut(pentagram);
  EXPECT_EQ(result.quality, Triangulation::forced);
  ASSERT_EQ(result.triangles.size(), 3);
  double sum = 0;
  for (const auto& [a, b, c] : result.triangles) {
    sum += twice_area(pentagram[a], pentagram[b], pentagram[c]);
  }
  EXPECT_NEAR(sum, twice_area(pentagram), 1e-12);
  EXPECT_EQ(cut({{0, 0}, {1, 0}, {0, 1}, {1, 1}}).quality, Triangulation::forced);
}

TEST(Triangulate, AnswersDegenerateOutlinesWithTheRightNumberOfTriangles) {
  for (std::size_t n = 3; n < 9; ++n) {
    Outline point(n, Vec2d{1, 2}), line, back_and_forth;
    for (std::size_t i = 0; i < n; ++i) {
      line.push_back({static_cast<double>(i), 0});
      back_and_forth.push_back({static_cast<double>(i % 2), 0});
    }
    for (const Outline& outline : {point, line, back_and_forth}) {
      const Cut result = cut(outline);
      EXPECT_EQ(result.triangles.size(), n - 2);
      EXPECT_EQ(result.quality, Triangulation::exact);
    }
  }
}

TEST(Triangulate, KeepsTheSignedAreaOfRandomScribbles) {
  test::Random random(77);
  for (int i = 0; i < 200; ++i) {
    Outline outline;
    const std::size_t n = 4 + random.index(30);
    for (std::size_t k = 0; k < n; ++k) {  // on a coarse grid: many coincidences
      outline.push_back(
          {static_cast<double>(random.index(5)), static_cast<double>(random.index(5))});
    }
    const Cut result = cut(outline);
    ASSERT_EQ(result.triangles.size(), n - 2);
    double sum = 0;
    for (const auto& [a, b, c] : result.triangles) {
      ASSERT_LT(std::max({a, b, c}), n);
      sum += twice_area(outline[a], outline[b], outline[c]);
    }
    if (n > 4) {
      EXPECT_NEAR(sum, twice_area(outline), 1e-9);
    }
  }
}

TEST(Triangulate, EndsInTimeOnLargeAndMaliciousOutlines) {
  test::Random random(5);
  const auto start = std::chrono::steady_clock::now();
  Outline scribble;
  for (int i = 0; i < 8000; ++i) scribble.push_back(random.uniform2());
  EXPECT_EQ(cut(scribble).triangles.size(), scribble.size() - 2);
  const Outline large = star(random, 30000);
  EXPECT_EQ(cut(large).quality, Triangulation::exact);
  Outline repeated;
  for (int i = 0; i < 100000; ++i)
    repeated.push_back({i % 4 < 2 ? 0.0 : 1.0, (i + 1) % 4 < 2 ? 0.0 : 1.0});
  EXPECT_EQ(cut(repeated).triangles.size(), repeated.size() - 2);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST(Triangulate, FitsAPlaneToWarpedPolygons) {
  test::Random random(21);
  for (int i = 0; i < 50; ++i) {
    const Outline outline = star(random, 12);
    const Plane plane = random_plane(random);
    const Vec3d n = cross(plane.u, plane.v);
    std::vector<Vec3d> corners;
    for (const Vec2d p : outline) corners.push_back(plane.at(p) + n * random.uniform(-0.02, 0.02));
    Triangles triangles;
    PolygonTriangulator().triangulate(corners, triangles);
    Vec3d sum;
    for (const auto& [a, b, c] : triangles) {
      sum += cross(corners[b] - corners[a], corners[c] - corners[a]);
    }
    // The area vector of a closed outline does not depend on how it is filled.
    Vec3d whole;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      whole += cross(corners[k], corners[(k + 1) % corners.size()]);
    }
    EXPECT_LT(length(sum - whole), 1e-9);
  }
}

}  // namespace
}  // namespace lapidary::geometry
