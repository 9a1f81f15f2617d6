// What a scene shares with the one before it, and that it is the same without.

#include <functional>

#include <gtest/gtest.h>

#include "geometry/curved_models.h"
#include "meshes.h"

namespace lapidary::geometry {
namespace {

using Term = Expression::Term;
using Compounds = SolidScene::Compounds;

MeshBody mesh_body(double corner, double uv) {
  TriangleMesh mesh = meshes::cube();
  mesh.positions[7].x = static_cast<float>(corner);
  mesh.uvs.assign(mesh.positions.size(), {0.5f, 0.5f});
  mesh.uvs[3].x = static_cast<float>(uv);
  return make_mesh_body(std::make_shared<const TriangleMesh>(std::move(mesh)));
}

Polyhedron gem(double height) {
  const HalfSpace planes[]{{{0, 0, height}, {0, 0, 1}}, {{0, 0, -1}, {0, 0, -1}},
                           {{1, 0, 0}, {1, 0, 0}},      {{-1, 0, 0}, {-1, 0, 0}},
                           {{0, 1, 0}, {0, 1, 0}},      {{0, -1, 0}, {0, -1, 0}}};
  return *intersection(planes);
}

Polygon with_hole(double x) {
  return {{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{{0.5, 0.5}, {0.5, 1}, {x, 0.5}}}};
}

/// A solid of each kind, made anew each time; each number that it is made of differs with one of
/// the parameters alone.
using Make = std::function<Solid(double)>;
const Make makers[]{
    [](double d) {
      return Sphere{{0, 0, 0}, 1 + d};
    },
    [](double d) {
      return Box{{-1, -1, -1}, {1, 1 + d, 1}};
    },
    [](double d) {
      return HalfSpace{{0, 0, d}, {0, 0.1, 1}};
    },
    [](double d) {
      return Cylinder{{0, 0, 0}, {0, d, 1}, 0.5};
    },
    [](double d) { return mesh_body(1 + d, 0.25); },
    [](double d) { return mesh_body(1, 0.25 + d); },
    [](double d) { return gem(1 + d); },
    [](double d) {
      const Vec3d points[]{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1 + d}};
      return hull_of(points);
    },
    [](double d) {
      return Cone{{0, 0, 0}, {0, 0, 1}, 1, 0.5 + d};
    },
    [](double d) { return make_prism(with_hole(1 + d), 1, 0.5); },
    [](double d) { return make_prism(with_hole(1), 1 + d, 0.5); },
    [](double d) { return make_prism(with_hole(1), 1, 0.5 + d); },
    [](double d) {
      return Torus{{0, 0, 0}, {0, 0, 1}, 1, 0.25 + d};
    },
    [](double d) {
      return Quadric{std::make_shared<const QuadraticForm>(QuadraticForm{{1, 1, 2 + d}})};
    },
    [](double d) { return make_lathe(with_hole(1 + d), 90); },
    [](double d) { return make_lathe(with_hole(1), 90 + 50 * d); },
    [](double d) {
      return Superellipsoid{{0, 0, 0}, {1, 2, 1}, 0.5 + d, 1};
    }};

const Transform maps[]{{}, Transform::translation({0.1, -2, 0.7}), test::csg::odd_placement()};

/// A difference of the solids at `map`, with a ball; the solid number `changed` is another.
SolidScene::Parts parts_of(const Transform& map, std::size_t changed, double by) {
  SolidScene::Parts parts;
  std::vector<Term> terms{parts.expression.add(PlacedSolid(Sphere{{0, 0, 0}, 3}, {}))};
  for (std::size_t i = 0; i < std::size(makers); ++i) {
    const Solid solid = makers[i](i == changed ? by : 0);
    terms.push_back(~parts.expression.add(PlacedSolid(solid, map), static_cast<SurfaceTag>(i)));
  }
  Region region;
  region.root = parts.expression.add(Operation::intersect, terms);
  region.medium = 1;
  parts.regions = {region};
  return parts;
}

bool is_shared(const SolidScene& a, const SolidScene& b) {
  return &a.world() == &b.world();
}

TEST(KeptSolids, OfEveryKindAreSharedIfAllOfThemIsTheSame) {
  for (const Transform& map : maps) {
    Compounds kept;
    const SolidScene first(parts_of(map, 0, 0), nullptr, &kept);
    ASSERT_EQ(kept.world.get(), &first.world());
    for (std::size_t i = 0; i < std::size(makers); ++i) {
      Compounds again = kept;
      EXPECT_TRUE(is_shared(first, SolidScene(parts_of(map, i, 0), nullptr, &again)));
      EXPECT_FALSE(is_shared(first, SolidScene(parts_of(map, i, 0x1p-20), nullptr, &again))) << i;
      EXPECT_NE(again.world, kept.world);
    }
    Compounds moved = kept;
    const Transform other = map * Transform::translation({0, 0, 0x1p-30});
    EXPECT_FALSE(is_shared(first, SolidScene(parts_of(other, 0, 0), nullptr, &moved)));
  }
}

TEST(KeptSolids, AreOthersWhereZerosDiffer) {
  const auto scene = [](double zero, Compounds& kept) {
    Expression expression;
    const Term root = expression.add(PlacedSolid(Sphere{{zero, 0, 0}, 1}, {}));
    Region region;
    region.root = root;
    return SolidScene({std::move(expression), {}, {}, {region}}, nullptr, &kept);
  };
  Compounds kept;
  const SolidScene first = scene(0.0, kept);
  EXPECT_TRUE(is_shared(first, scene(0.0, kept)));
  EXPECT_FALSE(is_shared(first, scene(-0.0, kept)));
}

/// Two balls, or one cut by the other, with a third in two places.
struct Balls {
  Operation operation = Operation::intersect;
  bool complement = true;
  double instance = 4;
  double inner = 0.5;  ///< radius of the ball in the assembly
  SurfaceTag tag = 3, medium = 1;

  SolidScene::Parts parts() const {
    SolidScene::Parts parts;
    const Term a = parts.expression.add(PlacedSolid(Sphere{}, {}), tag);
    const Term b = parts.expression.add(PlacedSolid(Sphere{{0.5, 0, 0}, 1}, {}));
    const Term both[]{a, complement ? ~b : b};
    Region region;
    region.root = parts.expression.add(operation, both);
    region.medium = medium;
    parts.regions.push_back(region);
    for (const double radius : {inner, 0.25}) {
      Assembly assembly;
      assembly.root = assembly.expression.add(PlacedSolid(Sphere{{}, radius}, {}));
      parts.assemblies.push_back(assembly);
    }
    for (const double x : {-4.0, instance}) {
      for (const std::uint32_t assembly : {0u, 1u}) {
        region.instance = static_cast<std::uint32_t>(parts.instances.size());
        parts.instances.push_back({assembly, Transform::translation({x, 2.0 * assembly, 0})});
        parts.regions.push_back(region);
      }
    }
    return parts;
  }
};

void expect_same_sweeps(const SolidScene& a, const SolidScene& b) {
  test::Random random(5);
  std::size_t met = 0;
  for (int i = 0; i < 400; ++i) {
    Ray ray;
    ray.origin = random.direction() * 9.0;
    const Vec3d to{random.uniform(-5, 5), random.uniform(-1, 3), random.uniform(-1, 1)};
    ray.direction = to - ray.origin;
    const auto in_a = test::csg::sweep_all(a, ray), in_b = test::csg::sweep_all(b, ray);
    ASSERT_EQ(in_a.size(), in_b.size());
    met += in_a.size();
    for (std::size_t k = 0; k < in_a.size(); ++k) {
      EXPECT_EQ(in_a[k].t, in_b[k].t);
      EXPECT_EQ(in_a[k].tag, in_b[k].tag);
      EXPECT_EQ(in_a[k].leaf, in_b[k].leaf);
      EXPECT_EQ(in_a[k].place, in_b[k].place);
      EXPECT_EQ(in_a[k].before, in_b[k].before);
      EXPECT_EQ(in_a[k].after, in_b[k].after);
    }
  }
  EXPECT_GT(met, 50u);
}

TEST(KeptSolids, ChangeNothingOfWhatIsMet) {
  struct Case {
    Balls balls;
    bool world;       ///< is shared
    bool assemblies;  ///< the first of them
  };
  const Case cases[]{{{}, true, true},
                     {{.operation = Operation::unite}, false, true},
                     {{.complement = false}, false, true},
                     {{.instance = 4.5}, false, true},
                     {{.inner = 0.4}, false, false},
                     {{.tag = 7}, true, true},
                     {{.tag = inherited_surface}, true, true},
                     {{.medium = 2}, true, true}};
  for (const Case& c : cases) {
    Compounds kept;
    const SolidScene first(Balls{}.parts(), nullptr, &kept);
    const SolidScene after(c.balls.parts(), nullptr, &kept), alone(c.balls.parts());
    EXPECT_EQ(is_shared(first, after), c.world);
    EXPECT_EQ(&after.assembly(0) == &first.assembly(0), c.assemblies);
    EXPECT_EQ(&after.assembly(1), &first.assembly(1));
    expect_same_sweeps(after, alone);
    // And back, from what was left.
    expect_same_sweeps(SolidScene(Balls{}.parts(), nullptr, &kept), first);
  }
}

TEST(KeptSolids, AssembliesAreFoundWhereverTheyStand) {
  Compounds kept;
  SolidScene::Parts parts = Balls{}.parts();
  const SolidScene first(parts, nullptr, &kept);
  std::swap(parts.assemblies[0], parts.assemblies[1]);
  const SolidScene swapped(parts, nullptr, &kept);
  EXPECT_EQ(&swapped.assembly(0), &first.assembly(1));
  EXPECT_EQ(&swapped.assembly(1), &first.assembly(0));
  expect_same_sweeps(swapped, SolidScene(parts));
}

/// A cube of half-spaces, of which one may wear something else.
SolidScene::Parts cube(SurfaceTag most, SurfaceTag one) {
  SolidScene::Parts parts;
  std::vector<Term> terms;
  for (Patch patch = 0; patch < 6; ++patch) {
    const HalfSpace plane = gem(1).face(patch);
    terms.push_back(parts.expression.add(PlacedSolid(plane, {}), patch == 2 ? one : most));
  }
  Region region;
  region.root = parts.expression.add(Operation::intersect, terms);
  region.medium = 1;
  parts.regions = {region};
  return parts;
}

TEST(KeptSolids, AreFusedAsTheTagsOfHalfSpacesAsk) {
  struct Case {
    SurfaceTag most, one;
    bool shared;
  };
  // The order of two tags decides which leaf is fused first.
  for (const auto& [first_one, cases] :
       {std::pair(4u, std::vector<Case>{{4, 4, true}, {9, 9, true}, {4, 5, false}}),
        std::pair(5u,
                  std::vector<Case>{{4, 6, true}, {9, 12, true}, {4, 4, false}, {6, 4, false}})}) {
    for (const Case& c : cases) {
      Compounds kept;
      const SolidScene first(cube(4, first_one), nullptr, &kept);
      const SolidScene after(cube(c.most, c.one), nullptr, &kept), alone(cube(c.most, c.one));
      EXPECT_EQ(is_shared(first, after), c.shared) << c.most << " " << c.one;
      ASSERT_EQ(after.world().leaves().size(), alone.world().leaves().size());
      expect_same_sweeps(after, alone);
    }
  }
}

}  // namespace
}  // namespace lapidary::geometry
