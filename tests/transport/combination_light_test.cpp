#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "sampling/mis.h"
#include "sampling/warp.h"
#include "scene/solid_builders.h"
#include "support/random.h"
#include "transport/probe.h"

namespace lapidary::test {
namespace {

using description::ObjectPtr;
using description::Quantity;
using geometry::Box;
using geometry::Cylinder;
using geometry::HalfSpace;
using geometry::Sphere;

// Combinations that shine, over a matte ground of albedo 1, which shows its irradiance over pi: the
// share of its hemisphere, by the cosine, that they fill, times their radiance.

constexpr double L = 2.0;

TinyScene over_ground(const std::vector<ObjectPtr>& objects) {
  TinyScene tiny;
  tiny.add(HalfSpace{}, matte(1.0));
  for (const ObjectPtr& object : objects) tiny.description.objects.push_back(object);
  return tiny;
}

/// What a camera sees of `spot` on the ground, from aside.
RunningMean seen_at(const scene::Scene& scene, Vec3d spot) {
  return radiance(scene, ray_to(spot + Vec3d{-1, -2, 0.7}, spot), {.samples = 1024});
}

// The oracle: solids as intervals of rays, by school formulas, summed over a fine grid.

struct Stretch {
  double from = -infinity, to = infinity;
  bool ahead() const { return from < to && to > 0; }
};
using Body = std::function<Stretch(Vec3d o, Vec3d d)>;

Stretch between_roots(double a, double half_b, double c) {
  const double discriminant = half_b * half_b - a * c;
  if (!(discriminant > 0)) return {0, 0};
  const double root = std::sqrt(discriminant);
  return {(-half_b - root) / a, (-half_b + root) / a};
}

Body ball_at(Vec3d center, double r) {
  return [=](Vec3d o, Vec3d d) {
    return between_roots(dot(d, d), dot(o - center, d), dot(o - center, o - center) - r * r);
  };
}
Body tube(Vec3d through, Vec3d axis, double r) {
  return [=](Vec3d o, Vec3d d) {
    const Vec3d w = cross(d, axis), v = cross(o - through, axis);
    return between_roots(dot(w, w), dot(v, w), dot(v, v) - r * r * dot(axis, axis));
  };
}
/// z >= x^2 + y^2 over `foot`.
Body bowl_at(Vec3d foot) {
  return [=](Vec3d o, Vec3d d) {
    const Vec3d q = o - foot;
    return between_roots(d.x * d.x + d.y * d.y, q.x * d.x + q.y * d.y - 0.5 * d.z,
                         q.x * q.x + q.y * q.y - q.z);
  };
}
Body below(Vec3d point, Vec3d normal) {
  return [=](Vec3d o, Vec3d d) -> Stretch {
    const double t = dot(point - o, normal) / dot(d, normal);
    return dot(d, normal) > 0 ? Stretch{-infinity, t} : Stretch{t, infinity};
  };
}
Body common(std::vector<Body> bodies) {
  return [=](Vec3d o, Vec3d d) {
    Stretch all;
    for (const Body& body : bodies) {
      const Stretch s = body(o, d);
      all = {std::max(all.from, s.from), std::min(all.to, s.to)};
    }
    return all;
  };
}
Body slab(Vec3d min, Vec3d max) {
  return common({below(max, {1, 0, 0}), below(max, {0, 1, 0}), below(max, {0, 0, 1}),
                 below(min, {-1, 0, 0}), below(min, {0, -1, 0}), below(min, {0, 0, -1})});
}

using Meets = std::function<bool(Vec3d o, Vec3d d)>;

Meets is_met(const Body& body) {
  return [=](Vec3d o, Vec3d d) { return body(o, d).ahead(); };
}
Meets is_met_without(const Body& body, const Body& hole) {
  return [=](Vec3d o, Vec3d d) {
    const Stretch b = body(o, d), h = hole(o, d);
    if (!b.ahead()) return false;
    if (!(h.from < h.to)) return true;
    return Stretch{b.from, std::min(b.to, h.from)}.ahead() ||
           Stretch{std::max(b.from, h.to), b.to}.ahead();
  };
}

/// By the cosine, of the hemisphere over a point of the ground; good to about 3e-4 relative.
double share_of_hemisphere(const Meets& meets, Vec3d p) {
  constexpr int n = 800;
  int met = 0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vec2d u{(i + 0.5) / n, (j + 0.5) / n};
      met += meets(p, sample_cosine_hemisphere(u)) ? 1 : 0;
    }
  }
  return met / (1.0 * n * n);
}

/// Within 3 standard errors: 0.27 % of false alarms when a line here is written.
void expect_lit(const scene::Scene& scene, const Meets& meets, const std::vector<Vec3d>& spots) {
  for (const Vec3d& spot : spots) {
    expect_radiance(seen_at(scene, spot), L * share_of_hemisphere(meets, spot), 5e-4);
  }
}

const std::vector<Vec3d> spots{{0.1, 0.2, 0}, {1.1, -0.4, 0}, {-1.4, 0.9, 0}};

// The closed form under a disk at the height h, off its axis by a: that of a hemisphere with its
// flat side down, as long as a <= r.
TEST(CombinationLight, HemisphereWithItsFlatSideDown) {
  const double r = 0.8, h = 1.5;
  const auto dome = intersect(solid(Sphere{{0, 0, h}, r}), solid(HalfSpace{{0, 0, h}, {0, 0, -1}}));
  const scene::Scene scene = over_ground({dressed(dome, lamp(L))}).build();
  ASSERT_EQ(scene.lights().size(), 1u);
  for (const double a : {0.0, 0.4, 0.79}) {
    const double s = h * h + a * a + r * r;
    const double share = 0.5 * (1 - (s - 2 * r * r) / std::sqrt(s * s - 4 * r * r * a * a));
    expect_radiance(seen_at(scene, {a, 0, 0}), L * share);
  }
}

TEST(CombinationLight, CutsOfASphere) {
  const Vec3d center{0, 0, 1.6};
  const auto check = [&](Vec3d point, Vec3d normal) {
    const auto cut = intersect(solid(Sphere{center, 0.9}), solid(HalfSpace{point, normal}));
    expect_lit(over_ground({dressed(cut, lamp(L))}).build(),
               is_met(common({ball_at(center, 0.9), below(point, normal)})), spots);
  };
  check(center, {0.4, 0.3, 0.8});
  check(center + Vec3d{0.2, 0, -0.5}, {0.4, -0.2, 0.3});  // a cap
}

TEST(CombinationLight, BoxMinusCylinder) {
  const Vec3d min{-0.7, -0.6, 1.1}, max{0.7, 0.6, 2.2}, axis{0.3, 1, 0.4}, middle{0, 0, 1.6};
  const auto pierced = subtract(solid(Box{min, max}),
                                solid(Cylinder{middle - 3.0 * axis, middle + 3.0 * axis, 0.42}));
  expect_lit(over_ground({dressed(pierced, lamp(L))}).build(),
             is_met_without(slab(min, max), tube(middle, axis, 0.42)), spots);
}

// A leaf without bounds, whose area nobody knows.
TEST(CombinationLight, BowlOfAQuadric) {
  const Vec3d foot{0.1, 0, 1};
  geometry::QuadraticForm form{{1, 1, 0}, {}, {0, 0, -1}, 0};
  const auto quadric =
      moved(*solid(geometry::Quadric{std::make_shared<const geometry::QuadraticForm>(form)}),
            Transform::translation(foot));
  const auto bowl = intersect(intersect(quadric, solid(HalfSpace{{0, 0, 1.7}, {0.2, 0, 1}})),
                              solid(Box{{-2, -2, 0.5}, {2, 2, 3}}));
  expect_lit(over_ground({dressed(bowl, lamp(L))}).build(),
             is_met(common({bowl_at(foot), below({0, 0, 1.7}, {0.2, 0, 1})})), spots);
}

// A closed mesh as an operand, with many patches.
TEST(CombinationLight, MeshOperand) {
  const auto mesh = std::make_shared<const geometry::TriangleMesh>(ball_mesh(5));
  const auto ball = std::make_shared<const description::Object>(
      description::Object{description::Mesh{mesh, {}}, nullptr, nullptr, nullptr, {}});
  const Vec3d normal{0.3, 0.1, 0.5};
  const auto cut =
      moved(*intersect(ball, solid(HalfSpace{{}, normal})), Transform::translation({0, 0, 1.6}));
  // The mesh is smaller than the ball by about 1e-3 of its solid angle.
  const Meets meets = is_met(common({ball_at({0, 0, 1.6}, 0.99975), below({0, 0, 1.6}, normal)}));
  const scene::Scene scene = over_ground({dressed(cut, lamp(L))}).build();
  for (const Vec3d& spot : spots) {
    expect_radiance(seen_at(scene, spot), L * share_of_hemisphere(meets, spot), 2e-3);
  }
}

/// Lambert's formula for what a polygon fills of the hemisphere, by the cosine.
double polygon_share(const std::vector<Vec3d>& corners, Vec3d p) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = normalize(corners[i] - p), b = normalize(corners[(i + 1) % corners.size()] - p);
    sum += std::acos(dot(a, b)) * normalize(cross(a, b)).z;
  }
  return std::abs(sum) / (2 * pi);
}

std::vector<Vec3d> rectangle(Vec3d min, Vec3d max) {
  return {
      {min.x, min.y, min.z}, {max.x, min.y, min.z}, {max.x, max.y, min.z}, {min.x, max.y, min.z}};
}

// Boxes that share the plane of their bottoms and overlap in it, all of which shine, or some.
TEST(CombinationLight, FacesThatCoincideCountOnce) {
  const Vec3d spot{0.1, 0, 0};
  const Box left{{-1, -0.5, 1}, {0.4, 0.5, 1.5}}, right{{-0.3, -0.5, 1}, {1, 0.5, 2}};
  const auto united = [&](const description::MaterialPtr& a, const description::MaterialPtr& b) {
    return seen_at(over_ground({unite(solid(left, a), solid(right, b))}).build(), spot);
  };
  const auto dark = matte(0.0), bright = lamp(L);
  const double all = polygon_share(rectangle(left.min, right.max), spot);
  const double of_left = polygon_share(rectangle(left.min, left.max), spot);
  expect_radiance(united(bright, bright), L * all);
  // What is written first shows where they overlap.
  expect_radiance(united(bright, dark), L * of_left);
  expect_radiance(united(dark, bright), L * (all - of_left));
  // Two whole boxes in one place, cut by a third that has the same faces.
  const auto same = intersect(unite(solid(left), solid(left)), solid(left));
  expect_radiance(seen_at(over_ground({dressed(same, bright)}).build(), spot), L * of_left);
}

// A dark block with a bright recess in its bottom: through the opening there is only light to see,
// and it comes out of the recess, not out of what was taken away.
TEST(CombinationLight, CutFacesOfAnOperand) {
  const Vec3d low{-0.5, -0.4, 1}, high{0.6, 0.3, 1.8}, spot{0.4, 0.5, 0};
  const auto block = solid(Box{{-1, -1, 1}, {1, 1, 2}}, matte(0.0));
  const auto hole = solid(Box{low - Vec3d{0, 0, 0.5}, high}, lamp(L));
  const double share = polygon_share(rectangle(low, high), spot);
  expect_radiance(seen_at(over_ground({subtract(block, hole)}).build(), spot), L * share);
  // The same by a rule for cuts.
  const auto cut = with_cut(subtract(block, solid(Box{low - Vec3d{0, 0, 0.5}, high})),
                            description::Cut::Rule::material, lamp(L));
  EXPECT_TRUE(description::has_light(over_ground({cut}).description));
  expect_radiance(seen_at(over_ground({cut}).build(), spot), L * share);
}

/// A slab of nine bars, whose bottom is the square (-1, 1)^2: too many to be copied.
ObjectPtr bars() {
  std::vector<ObjectPtr> all;
  for (int i = 0; i < 9; ++i) {
    const double x = -1 + 2 * i / 9.0;
    all.push_back(solid(Box{{x, -1, 0}, {-1 + 2 * (i + 1) / 9.0, 1, 0.3}}));
  }
  return description::make_combination(description::SetOperation::unite, all, {});
}

TEST(CombinationLight, InstancesShineEachFromItsPlace) {
  const ObjectPtr design = dressed(bars(), lamp(L));
  Mat3 leaning;
  leaning.row = {Vec3d{0.5, 0.3, 0.2}, Vec3d{0.1, -0.6, 0}, Vec3d{0.2, 0, 0.7}};
  const std::vector<Transform> places{
      Transform::translation({0.2, 0.1, 2}), *Transform::affine(leaning, {-1.5, 2, 1.2}),
      Transform::translation({2, -1, 1}) * Transform::scaling({0.4, 0.4, 0.4})};
  std::vector<ObjectPtr> copies;
  std::vector<Transform> to_own;
  const Vec3d spot{0.3, 0.4, 0};
  for (const Transform& place : places) {
    copies.push_back(moved(*design, place));
    to_own.push_back(place.inverse());
  }
  const scene::Scene scene = over_ground(copies).build();
  ASSERT_EQ(scene.world().solids().assembly_count(), 1u);
  EXPECT_EQ(scene.lights().size(), 3u);
  const Body body = slab({-1, -1, 0}, {1, 1, 0.3});
  const Meets meets = [&](Vec3d o, Vec3d d) {
    return std::ranges::any_of(to_own, [&](const Transform& own_from_world) {
      return body(own_from_world.point(o), own_from_world.vector(d)).ahead();
    });
  };
  expect_radiance(seen_at(scene, spot), L * share_of_hemisphere(meets, spot), 5e-4);
}

// Operands that shine, in a combination that stands in several places: one slot, three lights.
TEST(CombinationLight, InstancesMayShineInPart) {
  const ObjectPtr panel = solid(Box{{-0.5, -0.5, -0.1}, {0.5, 0.5, 0.1}}, lamp(L));
  const ObjectPtr design = dressed(unite(bars(), panel), matte(0.0));
  const std::vector<Vec3d> offsets{{0, 0, 1}, {2.5, 0, 1.5}, {0, -2.5, 2}};
  std::vector<ObjectPtr> copies;
  const Vec3d spot{0.8, -0.7, 0};
  for (const Vec3d& offset : offsets) {
    copies.push_back(moved(*design, Transform::translation(offset)));
  }
  const Body lit_part = slab({-0.5, -0.5, -0.1}, {0.5, 0.5, 0.1});
  const Body dark_part = slab({-1, -1, 0}, {1, 1, 0.3});
  // From below the panel is before its own bars, and nothing is before another's.
  const Meets meets = [&](Vec3d o, Vec3d d) {
    return std::ranges::any_of(offsets, [&](Vec3d at) {
      const Stretch lit = lit_part(o - at, d), dark = dark_part(o - at, d);
      return lit.ahead() && (!dark.ahead() || lit.from < dark.from);
    });
  };
  const scene::Scene scene = over_ground(copies).build();
  EXPECT_EQ(scene.world().solids().assembly_count(), 1u);
  EXPECT_EQ(scene.lights().size(), 3u);
  expect_radiance(seen_at(scene, spot), L * share_of_hemisphere(meets, spot), 5e-4);
}

// In a room whose walls shine everything is as bright as they are; a ball of albedo 1 shows that.
TEST(CombinationLight, RoomWhoseWallsShine) {
  TinyScene tiny;
  tiny.add_outside(Box{{-2, -2, -2}, {2, 3, 2}}, lamp(L));
  tiny.add(Sphere{{}, 0.5}, matte(1.0));
  expect_radiance(radiance(tiny.build(), ray({0, -1.5, 0.1}, {0, 1, 0})), L);
}

// As IsSeenInsideGlass, with a combination for a lamp.
TEST(CombinationLight, InsideOfGlassIsSeenThroughIt) {
  TinyScene tiny;
  const auto bulb = subtract(solid(Sphere{{}, 0.5}), solid(Sphere{{0, 0.5, 0}, 0.4}));
  tiny.description.objects.push_back(dressed(bulb, lamp(2.0)));
  tiny.add(Sphere{}, glass(1.5));
  expect_radiance(radiance(tiny.build(), ray({0, -2, 0}, {0, 1, 0})), 2.0 * 0.96 / 2.25);
}

/// The three ways to the irradiance of a spot, over pi: by lights alone, by chance alone, and what
/// a path tracer makes of both.
struct ThreeWays {
  RunningMean lights, chance, both;
};

ThreeWays measure(const scene::Scene& scene, Vec3d spot) {
  Random random(41);
  ThreeWays ways;
  ways.both = seen_at(scene, spot);
  const Wavelengths wavelengths = Wavelengths::sample(0.4);
  const geometry::Hit ground = scene.world().nearest(ray(spot + Vec3d{0, 0, 0.1}, {0, 0, -1}));
  const geometry::Surface surface =
      scene.world().surface(ray(spot + Vec3d{0, 0, 0.1}, {0, 0, -1}), ground);
  for (int i = 0; i < 60000; ++i) {
    const auto meet = [&](Vec3d wi) {
      const geometry::Ray r = geometry::World::leave(surface, wi);
      return std::pair(r, scene.world().nearest(r));
    };
    const auto [along, hit] = meet(sample_cosine_hemisphere(random.uniform2()));
    const bool lit =
        hit.kind != geometry::SurfaceKind::none && scene.light_index(hit) != scene::Slot::no_light;
    ways.chance.add(lit ? L : 0.0);

    const double choice = random.uniform();
    const auto chosen = scene.light_selector()->choose({spot}, choice);
    const auto sample = light::sample_illumination(
        scene.lights()[chosen.index], spot, {chosen.remainder, random.uniform2()}, wavelengths);
    double value = 0;
    if (sample && sample->wi.z > 0) {
      const auto [towards, found] = meet(sample->wi);
      const bool there = found.kind == geometry::SurfaceKind::solid &&
                         found.worn_leaf == sample->on_leaf->leaf &&
                         std::abs(found.t - sample->distance) < 1e-7;
      const double f_cos = sample->wi.z / pi;
      if (there) {
        value = static_cast<double>(sample->L[0]) * f_cos / (sample->pdf * chosen.probability);
        // Chance would weigh with the same density.
        const auto s = scene.world().surface(towards, found);
        const double pdf = light::pdf_illumination(
            scene.lights()[chosen.index], spot, sample->wi,
            {s.p, s.geometric_normal, {found.place, found.worn_leaf, found.worn_patch}});
        // Nearly edge-on, the cosine feels the roundings of the point.
        const double slope = std::abs(dot(s.geometric_normal, sample->wi));
        EXPECT_NEAR(pdf, sample->pdf, 1e-9 / (slope * slope) * pdf);
      }
    }
    ways.lights.add(value);
  }
  return ways;
}

void expect_agreement(const scene::Scene& scene) {
  for (const Vec3d& spot : spots) {
    const ThreeWays ways = measure(scene, spot);
    // z = 5, twice for each of 6 spots: a false alarm in 145,000.
    const auto agree = [](const RunningMean& a, const RunningMean& b) {
      return std::abs(a.mean() - b.mean()) < 5 * std::hypot(a.standard_error(), b.standard_error());
    };
    EXPECT_TRUE(agree(ways.lights, ways.both)) << ways.lights.mean() << ' ' << ways.both.mean();
    EXPECT_TRUE(agree(ways.chance, ways.both)) << ways.chance.mean() << ' ' << ways.both.mean();
    EXPECT_LT(ways.lights.standard_error(), 0.03 * ways.both.mean());
    EXPECT_LT(ways.both.standard_error(), 0.005 * ways.both.mean());
  }
}

TEST(CombinationLight, AllWaysToItAgree) {
  const auto lit = [](Vec3d center) {
    return subtract(unite(solid(Box{center - Vec3d{0.4, 0.4, 0.4}, center + Vec3d{0.4, 0.4, 0.4}}),
                          solid(Cylinder{center, center + Vec3d{0, 0.7, 0.5}, 0.3})),
                    unite(solid(Sphere{center - Vec3d{0.1, 0.2, 0.5}, 0.45}),
                          solid(HalfSpace{center + Vec3d{0, 0.6, 0.4}, {0, -1, -0.5}})));
  };
  expect_agreement(
      over_ground({dressed(lit({-0.6, 0, 1}), lamp(L)), dressed(lit({0.7, 0.3, 1.3}), lamp(L))})
          .build());
}

/// Planes about a point of which the sweep makes one polyhedron.
struct Crystal {
  explicit Crystal(Vec3d center) {
    for (const Vec3d d : {Vec3d{1, 0.2, 0.1},
                          {-1, 0.3, 0},
                          {0.1, 1, -0.2},
                          {0, -1, 0.4},
                          {0.2, 0.1, 1},
                          {0, 0, -1},
                          {0.6, 0.7, -0.5}}) {
      points.push_back(center + 0.45 * normalize(d));
      normals.push_back(d);
    }
  }
  std::vector<Vec3d> points, normals;
};

// Hits name half-spaces that are fused as they were stated, and so do draws.
TEST(CombinationLight, FusedHalfSpaces) {
  const Crystal crystal({0.1, 0, 1.5});
  auto cut = solid(HalfSpace{crystal.points[0], crystal.normals[0]});
  auto met = std::vector{below(crystal.points[0], crystal.normals[0])};
  for (std::size_t i = 1; i < crystal.points.size(); ++i) {
    cut = intersect(cut, solid(HalfSpace{crystal.points[i], crystal.normals[i]}));
    met.push_back(below(crystal.points[i], crystal.normals[i]));
  }
  const scene::Scene scene = over_ground({dressed(cut, lamp(L))}).build();
  ASSERT_EQ(scene.lights().size(), 1u);
  expect_lit(scene, is_met(common(met)), spots);
  expect_agreement(scene);
}

// A patch that a ray meets from its front more than once: only the first is lit.
TEST(CombinationLight, LeavesMayHideThemselves) {
  const auto ring = solid(geometry::Torus{{0, 0, 1.2}, normalize(Vec3d{0.3, 1, 0.1}), 0.6, 0.35});
  const auto open = subtract(ring, solid(HalfSpace{{0.3, 0, 1}, {-1, 0, 0.4}}));
  expect_agreement(over_ground({dressed(open, lamp(L))}).build());
}

// The same picture at every scale and far from the origin, in one of its places.
TEST(CombinationLight, IsTheSameAtEveryScale) {
  const auto pierced = subtract(solid(Box{{-0.5, -0.5, 1}, {0.5, 0.5, 1.6}}),
                                solid(Cylinder{{0.1, 0, 0}, {0.2, 0, 3}, 0.3}));
  const Vec3d spot{0.1, 0.2, 0};
  const Meets meets =
      is_met_without(slab({-0.5, -0.5, 1}, {0.5, 0.5, 1.6}), tube({0.1, 0, 0}, {0.1, 0, 3}, 0.3));
  const double expected = L * share_of_hemisphere(meets, spot);
  for (const double scale : {1e-6, 1.0, 1e6}) {
    for (const Vec3d& offset : {Vec3d{}, Vec3d{1e5, -2e5, 3e5}}) {
      const Transform place = Transform::scaling({scale, scale, scale}) *
                              Transform::translation(offset) * Transform::rotation({1, 2, 3}, 0.4);
      TinyScene tiny;
      tiny.add(HalfSpace{}, matte(1.0), place);
      tiny.description.objects.push_back(moved(*dressed(pierced, lamp(L)), place));
      const Vec3d at = place.point(spot), from = place.point(spot + Vec3d{-1, -2, 0.7});
      expect_radiance(radiance(tiny.build(), ray_to(from, at), {.samples = 512}), expected, 5e-4);
    }
  }
}

double seen(const TinyScene& tiny, const geometry::Ray& along) {
  return radiance(tiny.build(), along, {{16}, 4, 4}).mean();
}

TEST(CombinationLight, OfPowerIsSpreadOverWhatIsThere) {
  const double watts = 50.0, metres = 0.01;
  const auto light = material(description::Emissive{{Quantity::power, grey(watts)}});
  const auto pierced =
      subtract(solid(Box{{-1, -1, -1}, {1, 1, 1}}), solid(Cylinder{{0, 0, -2}, {0, 0, 2}, 0.5}));
  const double area = 24 - 2 * pi * 0.25 + 2 * pi * 0.5 * 2;
  const auto expect = [&](const ObjectPtr& object, double area_lit) {
    TinyScene tiny;
    tiny.description.metres_per_unit = metres;
    tiny.description.objects = {object};
    const double expected = watts / (pi * area_lit * metres * metres);
    EXPECT_NEAR(seen(tiny, ray_to({0.1, -9, 0.1}, {0.1, 0, 0.1})), expected, 1e-3 * expected);
  };
  expect(dressed(pierced, light), area);
  expect(moved(*dressed(pierced, light), Transform::scaling({3, 3, 3})), 9 * area);
  // Of the cut face alone: a ball that is taken away from the front.
  const auto dented = subtract(solid(Box{{-1, -1, -1}, {1, 1, 1}}, matte(0.5)),
                               solid(Sphere{{0, -1, 0}, 0.5}, light));
  expect(dented, 2 * pi * 0.25);
}

}  // namespace
}  // namespace lapidary::test
