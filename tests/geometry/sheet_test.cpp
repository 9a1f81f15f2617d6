#include "geometry/sheet.h"

#include <cmath>

#include <gtest/gtest.h>

#include "base/error.h"
#include "exact_solids.h"
#include "hostile_lines.h"
#include "support/chi_squared.h"

namespace lapidary::geometry {
namespace {

using exact::Quad;
using exact::Vec;
using lapidary::test::Random;

Rectangle random_rectangle(const hostile::Setting& s, Random& random) {
  Rectangle r{s.point(random), {}, {}};
  do {
    r.edge_u = s.nonzero(random) * s.scale, r.edge_v = s.nonzero(random) * s.scale;
  } while (length(cross(r.edge_u, r.edge_v)) < 0.01 * length(r.edge_u) * length(r.edge_v));
  r.handedness = random.index(2) == 0 ? Handedness::right : Handedness::left;
  return r;
}

Disk random_disk(const hostile::Setting& s, Random& random) {
  const Vec3d center = s.point(random), normal = s.nonzero(random) * random.magnitude(-3, 3);
  return {center, normal, s.size(random)};
}

/// Aimed so that about half of the lines hit.
Line random_line(const hostile::Setting& s, Vec3d center, Random& random) {
  Line line = hostile::line(s, random);
  if (random.index(2) == 0) {
    const Vec3d target = center + random.direction() * (s.scale * random.uniform(0, 0.7));
    if (!(target == line.origin)) line.direction = target - line.origin;
  }
  return line;
}

struct Expected {
  Quad t;
  bool from_front;
  double inside_by;  ///< relative to the sheet's size; negative outside
};

Expected expected(const Rectangle& r, const Line& line) {
  const Vec u(r.edge_u), v(r.edge_v), o(line.origin), d(line.direction);
  const Vec n = exact::cross(u, v);
  const Quad nn = exact::dot(n, n);
  Expected e{-exact::dot(o - Vec(r.corner), n) / exact::dot(d, n), false, 0};
  const Vec p = o + d * e.t - Vec(r.corner);
  const Quad a = exact::dot(exact::cross(p, v), n) / nn;
  const Quad b = exact::dot(exact::cross(u, p), n) / nn;
  e.inside_by = static_cast<double>(exact::least(exact::least(a, 1 - a), exact::least(b, 1 - b)));
  e.from_front = (exact::dot(d, n) < 0) == (r.handedness == Handedness::right);
  return e;
}

Expected expected(const Disk& disk, const Line& line) {
  const Vec o(line.origin), d(line.direction), n(disk.normal), c(disk.center);
  Expected e{-exact::dot(o - c, n) / exact::dot(d, n), exact::dot(d, n) < 0, 0};
  const Vec p = o + d * e.t - c;
  e.inside_by = 1.0 - static_cast<double>(exact::length(p)) / disk.radius;
  return e;
}

Vec3d center_of(const Rectangle& r) {
  return r.corner + (r.edge_u + r.edge_v) * 0.5;
}
Vec3d center_of(const Disk& disk) {
  return disk.center;
}

template <typename MakeSheet>
void compare(MakeSheet make) {
  Random random(1);
  int hits = 0;
  double worst = 0.0;
  for (int i = 0; i < 100000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const auto sheet = make(setting, random);
    const Line line = random_line(setting, center_of(sheet), random);
    const double steep = dot(normalize(line.direction), front_normal(Sheet{sheet}));
    if (std::abs(steep) < 1e-12) continue;  // parallel within rounding: its own test
    const auto event = intersect(Sheet{sheet}, line);
    const Expected e = expected(sheet, line);
    if (!event) {
      // A hit that is dropped lies on the rim; the rim of a disk is sharp.
      const double scale = length(line.origin - center_of(sheet)) / setting.scale + 1.0;
      ASSERT_LE(e.inside_by, 1e-14 * scale / std::abs(steep)) << i;
      continue;
    }
    ++hits;
    const double error = static_cast<double>(exact::magnitude(Quad(event->t) - e.t));
    ASSERT_LE(error, event->tau) << i;
    worst = std::max(worst, error / event->tau);
    ASSERT_EQ(event->crossing == Crossing::enter, e.from_front);
    // Nothing is hit beyond what rounding can excuse.
    const double reach = length(line.origin - center_of(sheet)) / setting.scale + 1.0;
    ASSERT_GE(e.inside_by, -1e-12 * reach / std::abs(steep)) << i;
  }
  EXPECT_GT(hits, 20000);
  EXPECT_GT(worst, 0.1);  // bounds ten times smaller would fail
}

TEST(Sheet, RectangleHitsStayWithinTheirBounds) {
  compare(random_rectangle);
}
TEST(Sheet, DiskHitsStayWithinTheirBounds) {
  compare(random_disk);
}

TEST(Sheet, ParallelLinesMiss) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d d{random.uniform(-1, 1), random.uniform(-1, 1), 0};
    const double height = random.index(2) == 0 ? 0.0 : random.uniform(-1, 1);
    EXPECT_FALSE(intersect(Sheet{Rectangle{}}, {{0, 0, height}, d}));
    EXPECT_FALSE(intersect(Sheet{Disk{}}, {{0, 0, height}, d}));
  }
}

TEST(Sheet, RectanglesThatShareAnEdgeLeaveNoGap) {
  Random random(3);
  int grazed = 0;
  for (int i = 0; i < 50000; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const Rectangle wall = random_rectangle(setting, random);
    const Vec3d fold = setting.nonzero(random) * setting.scale;
    const Rectangle other{wall.corner, wall.edge_u, fold};
    if (length(cross(front_normal(Sheet{wall}), cross(wall.edge_u, fold))) <
        0.1 * length(wall.edge_u) * length(fold))
      continue;  // in one plane
    // From between the two walls at a point of their edge, which rounding moves off it.
    const Vec3d target = wall.corner + wall.edge_u * random.uniform(0.01, 0.99);
    const double a = random.uniform(0.5, 5.0);
    const Vec3d origin = target + wall.edge_v * a + fold * random.uniform(0.5, 5.0);
    const Line line{origin, target - origin};
    ASSERT_TRUE(intersect(Sheet{wall}, line) || intersect(Sheet{other}, line)) << i;
    ++grazed;
  }
  EXPECT_GT(grazed, 10000);
}

TEST(Sheet, NormalsAndTextureCoordinatesAgree) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    hostile::Setting setting;
    setting.scale = random.magnitude(-3, 3);
    const Rectangle rectangle = random_rectangle(setting, random);
    const Sheet sheet = i % 2 == 0 ? Sheet{rectangle} : Sheet{random_disk(setting, random)};
    const BoundaryPoint b = sample_area(sheet, random.uniform2());
    const SurfaceUv s = surface_uv(sheet, b.p);
    const Vec3d moved = b.p + s.dpdu * 0.25 - s.dpdv * 0.5;
    const Vec2d uv = surface_uv(sheet, moved).uv;
    ASSERT_NEAR(uv.x - s.uv.x, 0.25, 1e-9);
    ASSERT_NEAR(uv.y - s.uv.y, -0.5, 1e-9);
    ASSERT_TRUE(s.uv.x > -1e-9 && s.uv.x < 1 + 1e-9 && s.uv.y > -1e-9 && s.uv.y < 1 + 1e-9);
    ASSERT_NEAR(length(b.normal), 1.0, 1e-15);
    ASSERT_EQ(b.normal, front_normal(sheet));
    const bool left = i % 2 == 0 && rectangle.handedness == Handedness::left;
    ASSERT_EQ(dot(cross(s.dpdu, s.dpdv), b.normal) < 0.0, left);
    ASSERT_DOUBLE_EQ(b.pdf_area, 1.0 / area(sheet));
    const Box3d box = bounds(sheet);
    const double slack = 1e-15 * (length(box.min) + length(box.max));
    const Vec3d margin{slack, slack, slack};
    ASSERT_TRUE((Box3d{box.min - margin, box.max + margin}).contains(b.p));
  }
}

TEST(Sheet, BoundsAreTight) {
  const Box3d box = bounds(Sheet{Disk{{1, 2, 3}, {0, 3, 4}, 5.0}});
  EXPECT_NEAR(box.max.x, 6.0, 1e-14);
  EXPECT_NEAR(box.max.y, 6.0, 1e-14);
  EXPECT_NEAR(box.max.z, 6.0, 1e-14);
  const Box3d flat = bounds(Sheet{Rectangle{}});
  EXPECT_NEAR(flat.max.x, 0.5, 1e-15);
  EXPECT_LT(flat.max.z, 1e-15);
}

TEST(Sheet, AreasAreThoseOfSchoolbooks) {
  EXPECT_DOUBLE_EQ(area(Sheet{Rectangle{{}, {2, 0, 0}, {1, 3, 0}}}), 6.0);
  EXPECT_DOUBLE_EQ(area(Sheet{Disk{{}, {0, 5, 0}, 3.0}}), 9.0 * pi);
}

TEST(Sheet, SamplesAreUniformByArea) {
  const Rectangle rectangle{{1, 2, 3}, {2, 0, 1}, {0, 3, 1}};
  const Disk disk{{1, 2, 3}, {0, 0, 2}, 0.5};
  test::SamplerTest settings;
  settings.significance = 1e-6;  // the false-alarm rate
  const auto flat = test::test_points(
      {},
      [&](Random& random) {
        return surface_uv(Sheet{rectangle}, sample_area(Sheet{rectangle}, random.uniform2()).p).uv;
      },
      [](Vec2d) { return 1.0; }, settings);
  EXPECT_TRUE(flat.accepted) << flat.message;
  const auto round = test::test_points(
      {},
      [&](Random& random) {
        const Vec3d p = sample_area(Sheet{disk}, random.uniform2()).p - disk.center;
        return Vec2d{0.5 + 0.5 * std::atan2(p.y, p.x) / pi, 4.0 * dot(p, p)};
      },
      [](Vec2d) { return 1.0; }, settings);
  EXPECT_TRUE(round.accepted) << round.message;
}

TEST(Sheet, TransformsKeepFrontAndTexture) {
  Random random(5);
  const hostile::Setting setting;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d axis = random.direction();
    const Transform turn = Transform::rotation(axis, random.uniform(0, 6));
    const double flip = i % 2 == 0 ? 1.0 : -1.0;
    const Sheet rectangle = random_rectangle(setting, random);
    const Transform shear = turn * Transform::scaling({flip * 2, 0.5, 3}) * turn;
    const Sheet image = transformed(rectangle, shear);
    const BoundaryPoint b = sample_area(rectangle, {0.3, 0.8});
    const SurfaceUv s = surface_uv(image, shear.point(b.p));
    ASSERT_NEAR(s.uv.x, 0.3, 1e-9);
    ASSERT_NEAR(s.uv.y, 0.8, 1e-9);
    ASSERT_NEAR(length(front_normal(image) - normalize(shear.normal(b.normal))), 0.0, 1e-9);

    const Sheet disk = random_disk(setting, random);
    const Transform similar = turn * Transform::scaling({2, 2, flip * 2});
    const Sheet larger = transformed(disk, similar);
    ASSERT_NEAR(area(larger) / area(disk), 4.0, 1e-12);
    const Vec3d n = normalize(similar.normal(front_normal(disk)));
    ASSERT_NEAR(length(front_normal(larger) - n), 0.0, 1e-12);
  }
}

TEST(Sheet, DisksRefuseUnevenScaling) {
  EXPECT_THROW(transformed(Sheet{Disk{}}, Transform::scaling({1, 2, 1})), Error);
}

}  // namespace
}  // namespace lapidary::geometry
