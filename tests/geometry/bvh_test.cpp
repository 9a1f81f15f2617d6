#include "geometry/bvh.h"

#include <random>
#include <set>

#include <gtest/gtest.h>

namespace lapidary::geometry {
namespace {

/// Slab test in long double, with no slack.
bool meets(const Box3d& box, const Line& line, double t_min, double t_max) {
  long double t0 = t_min, t1 = t_max;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const long double o = line.origin[axis], d = line.direction[axis];
    if (d == 0) {
      if (o < box.min[axis] || o > box.max[axis]) return false;
      continue;
    }
    const long double a = (box.min[axis] - o) / d, b = (box.max[axis] - o) / d;
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  return t0 <= t1;
}

class Scatter {
 public:
  explicit Scatter(unsigned seed) : random_(seed) {}

  /// Boxes of all sizes, flat ones and points among them, on a coarse grid so that faces coincide.
  Box3d box(double scale, Vec3d offset) {
    Box3d b;
    const Vec3d corner{grid(), grid(), grid()};
    b.min = offset + corner * scale;
    b.max = b.min + Vec3d{size(), size(), size()} * scale;
    return b;
  }

  Line line(double scale, Vec3d offset) {
    Line l{offset + Vec3d{grid(), grid(), grid()} * scale, {}};
    do {
      l.direction = {component(), component(), component()};
    } while (l.direction == Vec3d{});
    return l;
  }

 private:
  double grid() { return static_cast<double>(random_() % 41) * 0.25 - 5.0; }
  double size() { return static_cast<double>(random_() % 4) * 0.25; }
  double component() {
    const auto kind = random_() % 4;
    if (kind == 0) return 0.0;
    if (kind == 1) return random_() % 2 == 0 ? 1.0 : -1.0;
    return std::uniform_real_distribution<double>(-1, 1)(random_);
  }
  std::mt19937_64 random_;
};

/// From anywhere on the line, in any unit of t; `displacement` moves the line and is stated.
void expect_whole_line_misses_nothing(const Bvh& bvh, const std::vector<Box3d>& boxes, Line line,
                                      double displacement) {
  const Vec3d aside{displacement, -displacement, displacement};
  for (const double unit : {1.0, -1e-40, 1e40}) {
    for (const double t : {0.0, -64.0, 4096.0}) {
      const Line from{line.at(t) + aside, line.direction * unit, displacement, 0};
      std::set<std::uint32_t> visited;
      bvh.walk_line(from, [&](std::uint32_t item) {
        EXPECT_TRUE(visited.insert(item).second) << "visited twice";
      });
      for (std::uint32_t item = 0; item < boxes.size(); ++item) {
        if (meets(boxes[item], {line.at(t), line.direction}, -infinity, infinity)) {
          ASSERT_TRUE(visited.count(item)) << "item " << item << " from " << t;
        }
      }
    }
  }
}

void expect_nothing_missed(std::size_t count, double scale, Vec3d offset) {
  Scatter scatter(static_cast<unsigned>(count));
  std::vector<Box3d> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(scatter.box(scale, offset));
  const Bvh bvh(boxes);
  for (int i = 0; i < 400; ++i) {
    const Line line = scatter.line(scale, offset);
    const double t_max = i % 2 == 0 ? infinity : 3.0 * scale;
    std::set<std::uint32_t> visited;
    bvh.walk(line, t_max, [&](std::uint32_t item, double&) {
      EXPECT_TRUE(visited.insert(item).second) << "visited twice";
      return false;
    });
    for (std::uint32_t item = 0; item < boxes.size(); ++item) {
      if (meets(boxes[item], line, 0.0, t_max)) {
        ASSERT_TRUE(visited.count(item))
            << count << " boxes at scale " << scale << ", item " << item;
      }
    }
    expect_whole_line_misses_nothing(bvh, boxes, line, i % 3 == 0 ? 1e-3 * scale : 0.0);
  }
}

TEST(Bvh, VisitsEveryBoxThatALineMeets) {
  for (const std::size_t count : {1u, 2u, 7u, 8u, 9u, 64u, 500u}) {
    expect_nothing_missed(count, 1.0, {});
    expect_nothing_missed(count, 1e-9, {});
    expect_nothing_missed(count, 1e9, {});
    expect_nothing_missed(count, 1.0, {1e6, -1e6, 1e6});
  }
}

TEST(Bvh, HoldsManyEqualBoxes) {
  const std::vector<Box3d> boxes(1000, Box3d{{0, 0, 0}, {1, 1, 1}});
  const Bvh bvh(boxes);
  std::size_t visits = 0;
  bvh.walk({{0.5, 0.5, -1}, {0, 0, 1}}, infinity, [&](std::uint32_t, double&) {
    ++visits;
    return false;
  });
  EXPECT_EQ(visits, boxes.size());
}

/// The items that a line meets, in the order of the walk.
std::vector<std::uint32_t> met(const Bvh& bvh, const Line& line) {
  std::vector<std::uint32_t> items;
  bvh.walk(line, infinity, [&](std::uint32_t item, double&) {
    items.push_back(item);
    return false;
  });
  return items;
}

TEST(Bvh, OfManyBoxesMissesNothingAndIsTheSameForAnyThreads) {
  Scatter scatter(11);
  std::vector<Box3d> boxes;
  for (std::size_t i = 0; i < 60000; ++i) boxes.push_back(scatter.box(1.0, {0.01, 0.02, 0.03}));
  constexpr std::uint32_t first[]{0, 1, 40000, 40300};
  ThreadPool pool(3);
  const Bvh alone(boxes, first), together(boxes, first, &pool);
  EXPECT_EQ(alone.bytes(), together.bytes());
  for (std::size_t k = 0; k < std::size(first); ++k) {
    EXPECT_EQ(alone.root(k).bits(), together.root(k).bits());
  }
  const Bvh whole(boxes), parallel(boxes, std::span(first, 1), &pool);
  for (int i = 0; i < 20; ++i) {
    const Line line = scatter.line(1.0, {});
    const std::vector<std::uint32_t> items = met(whole, line);
    EXPECT_EQ(items, met(parallel, line));
    const std::set<std::uint32_t> visited(items.begin(), items.end());
    EXPECT_EQ(visited.size(), items.size());
    for (std::uint32_t item = 0; item < boxes.size(); ++item) {
      const bool expected = meets(boxes[item], line, 0.0, infinity);
      ASSERT_TRUE(!expected || visited.count(item) == 1) << item;
    }
  }
}

/// Every item of the hierarchy below `at`, without a line.
void collect(const Bvh& bvh, Bvh::Ref at, std::multiset<std::uint32_t>& items) {
  if (at.is_item()) {
    items.insert(at.item());
    return;
  }
  // From the middle of the boxes every direction meets all of them.
  bvh.expand(at, Bvh::Slabs({{0.5, 0.5, 0.5}, {1, 2, 3}}), infinity,
             [&](float, float, Bvh::Ref child) { collect(bvh, child, items); });
}

TEST(Bvh, OfSeveralHierarchiesEachHasItsOwnItems) {
  const std::vector<Box3d> boxes(50000, Box3d{{0, 0, 0}, {1, 1, 1}});
  constexpr std::uint32_t first[]{0, 3, 4, 30000, 30009};
  ThreadPool pool(2);
  const Bvh bvh(boxes, first, &pool);
  for (std::size_t k = 0; k < std::size(first); ++k) {
    std::multiset<std::uint32_t> items, expected;
    collect(bvh, bvh.root(k), items);
    const std::size_t end = k + 1 < std::size(first) ? first[k + 1] : boxes.size();
    for (std::size_t i = first[k]; i < end; ++i) expected.insert(static_cast<std::uint32_t>(i));
    EXPECT_EQ(items, expected);
  }
}

TEST(Bvh, HoldsWhatReachesBeyondFloats) {
  std::vector<Box3d> boxes;
  for (int i = 0; i < 100; ++i) {
    const double x = 0.1 * i;
    boxes.push_back({{x, -1, -1}, {x + 0.05, 1, 1}});
  }
  boxes.push_back({{-1e300, -1e300, 2}, {1e300, 1e300, 3}});
  boxes.push_back({{-1e38, -1, 4}, {-9e37, 1, 5}});
  const Bvh bvh(boxes);
  EXPECT_EQ(met(bvh, {{0, 0.5, 2.5}, {1, 1, 0}}), (std::vector<std::uint32_t>{100}));
  const std::vector<std::uint32_t> far = met(bvh, {{-9.5e37, 0, 10}, {0, 0, -1}});
  EXPECT_EQ(std::multiset<std::uint32_t>(far.begin(), far.end()).count(101), 1u);
  EXPECT_EQ(met(bvh, {{5.02, 0, -5}, {0, 0, 1}}).size(), 2u);
}

TEST(Bvh, EndsWhenAskedAndSkipsWhatLiesBeyond) {
  std::vector<Box3d> boxes;
  for (int i = 0; i < 100; ++i) {
    boxes.push_back({{double(i), 0, 0}, {i + 0.5, 1, 1}});
  }
  const Bvh bvh(boxes);
  const Line line{{-1, 0.5, 0.5}, {1, 0, 0}};
  int visits = 0;
  EXPECT_TRUE(bvh.walk(line, infinity, [&](std::uint32_t, double&) { return ++visits == 3; }));
  EXPECT_EQ(visits, 3);
  visits = 0;
  EXPECT_FALSE(bvh.walk(line, infinity, [&](std::uint32_t item, double& t_max) {
    t_max = std::min(t_max, item + 1.25);
    ++visits;
    return false;
  }));
  EXPECT_LT(visits, 10);
}

TEST(Bvh, EmptyMeetsNothing) {
  EXPECT_FALSE(
      Bvh().walk({{0, 0, 0}, {1, 0, 0}}, infinity, [](std::uint32_t, double&) { return true; }));
}

}  // namespace
}  // namespace lapidary::geometry
