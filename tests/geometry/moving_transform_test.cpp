#include "geometry/moving_transform.h"

#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::geometry {
namespace {

using test::Random;
using Vec3l = Vec3<long double>;

Motion random_motion(Random& random) {
  Motion m;
  m.center = random.direction() * random.magnitude(-2, 2);
  m.turn = {random.direction(), random.uniform(-8, 8)};
  m.scale = {random.magnitude(-1, 1), random.magnitude(-1, 1), random.magnitude(-1, 1)};
  m.travel = random.direction() * random.magnitude(-2, 2);
  if (random.index(4) == 0) m.scale = {1, 1, 1};
  if (random.index(4) == 0) m.turn.angle = 0;
  return m;
}

/// What a motion says, by Rodrigues' formula in long double.
Vec3l moved(const Motion& m, double time, Vec3l p) {
  const long double t = time;
  const Vec3l one{1, 1, 1}, f = one + (Vec3l(m.scale) - one) * t;
  Vec3l v = p - Vec3l(m.center);
  v = {v.x * f.x, v.y * f.y, v.z * f.z};
  const Vec3l n = normalize(Vec3l(m.turn.axis));
  const long double angle = m.turn.angle * t, c = std::cos(angle), s = std::sin(angle);
  v = v * c + cross(n, v) * s + n * (dot(n, v) * (1 - c));
  return Vec3l(m.center) + Vec3l(m.travel) * t + v;
}

Vec3l mapped(const Transform& map, Vec3l p) {
  const Mat3& m = map.linear();
  return Vec3l{dot(Vec3l(m.row[0]), p), dot(Vec3l(m.row[1]), p), dot(Vec3l(m.row[2]), p)} +
         Vec3l(map.offset());
}

TEST(Motion, IsWhatItSaysWithinItsError) {
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const Motion m = random_motion(random);
    const double time = i % 10 == 0 ? i % 20 / 10 : random.uniform();
    const Vec3d p = random.direction() * random.magnitude(-3, 3);
    const RoundedMap map = map_at(m, time);
    const long double off = length(mapped(map.map, Vec3l(p)) - moved(m, time, Vec3l(p)));
    const double of_reference = 1e-18 * (length(p) + length(m.center) + length(m.travel));
    EXPECT_LE(off, map.error.linear * length(p) + map.error.offset + 10 * of_reference);
    // And the error is one of rounding.
    const double size = max_component(m.scale) + 1;
    EXPECT_LE(map.error.linear, 1e-13 * size);
  }
}

TEST(Motion, BeginsAtRest) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    Motion m = random_motion(random);
    m.center = {};
    EXPECT_EQ(map_at(m, 0).map.linear(), Mat3::identity());
    EXPECT_EQ(map_at(m, 0).map.offset(), Vec3d());
  }
}

/// Three motions between fixed maps.
struct Nested {
  std::vector<Motion> motions;
  std::vector<Transform> maps;
  MovingTransform whole;

  explicit Nested(Random& random) : whole(random_map(random)) {
    maps.push_back(whole.at(0));
    for (int i = 0; i < 3; ++i) {
      motions.push_back(random_motion(random));
      motions.back().scale = {random.uniform(0.5, 2), 1, random.uniform(0.5, 2)};
      maps.push_back(random_map(random));
      whole.append(motions.back());
      whole.append(maps.back());
    }
  }
  Vec3l moved(double time, Vec3l p) const {
    for (std::size_t i = motions.size(); i-- > 0;) {
      p = geometry::moved(motions[i], time, mapped(maps[i + 1], p));
    }
    return mapped(maps[0], p);
  }

 private:
  static Transform random_map(Random& random) {
    return Transform::translation(random.direction()) *
           Transform::rotation(random.direction(), random.uniform(0, 6)) *
           Transform::scaling({random.uniform(0.5, 2), random.uniform(0.5, 2), 1});
  }
};

TEST(MovingTransform, ComposesMotionsWithinTheErrorOfItsLines) {
  Random random(3);
  for (int i = 0; i < 3000; ++i) {
    const Nested nested(random);
    const double time = random.uniform();
    const Vec3d p = random.direction() * random.magnitude(-1, 1);
    const Vec3l world = nested.moved(time, Vec3l(p));
    const Transform at = nested.whole.at(time);
    EXPECT_LT(length(mapped(at, Vec3l(p)) - world), 1e-11L * (1 + length(world)));
    // A line of the world through the point: its own origin is off by no more than it says.
    const OwnSpace space = nested.whole.space_at(time);
    const Line line = space.line({Vec3d(world), {1, 0, 0}});
    const Vec3l own_error = Vec3l(line.origin) - Vec3l(p);
    const double rounding = frobenius_norm(space.own_from_world()) * 2e-16 * length(Vec3d(world));
    EXPECT_LE(static_cast<double>(length(own_error)), line.origin_error + rounding);
    EXPECT_LT(line.origin_error, 1e-9);
  }
}

TEST(MovingTransform, GivesTheSameBitsForTheSameTime) {
  Random random(4);
  const Nested nested(random);
  for (int i = 0; i < 100; ++i) {
    const double time = random.uniform();
    EXPECT_EQ(nested.whole.at(time), nested.whole.at(time));
    EXPECT_EQ(nested.whole.at(time), nested.whole.space_at(time).world_from_own());
  }
}

TEST(MovingTransform, SweepsNoMoreThanItHasTo) {
  Random random(5);
  for (int i = 0; i < 60; ++i) {
    const Nested nested(random);
    const Motion motion = random_motion(random);
    const Vec3d corner = random.direction(), opposite = random.direction();
    const Box3d box{min(corner, opposite), max(corner, opposite)};
    const Box3d by_one = swept(motion, box), by_all = nested.whole.swept(box);
    Box3d needed;
    for (int k = 0; k < 400; ++k) {
      const double time = k < 200 ? k / 199.0 : random.uniform();
      const Vec3d share{random.uniform(), random.uniform(), random.uniform()}, e = box.extent();
      const Vec3d inside = box.min + Vec3d{share.x * e.x, share.y * e.y, share.z * e.z};
      for (unsigned c = 0; c < 9; ++c) {
        const Vec3l p(c < 8 ? box.corner(c) : inside);
        const Vec3d image(moved(motion, time, p));
        needed.extend(image);
        EXPECT_TRUE(by_one.contains(image));
        EXPECT_TRUE(by_all.contains(Vec3d(nested.moved(time, p))));
      }
    }
    const double reach = length(needed.extent());
    EXPECT_LT(length(by_one.extent() - needed.extent()), 0.02 * reach);
  }
  EXPECT_EQ(swept(random_motion(random), Box3d::all()), Box3d::all());
  EXPECT_TRUE(swept(random_motion(random), Box3d{}).empty());
}

}  // namespace
}  // namespace lapidary::geometry
