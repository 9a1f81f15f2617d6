#include "scene/assemble.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>

#include "base/error.h"
#include "description/solids.h"
#include "scene/solid_builders.h"
#include "scene/tiny_scene.h"
#include "support/random.h"

namespace lapidary::test {
namespace {

using description::Cut;
using description::make_group;
using description::Object;
using description::ObjectPtr;
using description::SetOperation;
using geometry::Expression;
using scene::Solids;
using testing::HasSubstr;

Solids assembled(std::vector<ObjectPtr> objects, ObjectPtr section = nullptr) {
  description::SceneDescription scene;
  scene.objects = std::move(objects);
  scene.section = std::move(section);
  return scene::assemble(scene);
}

std::size_t leaf_count(const ObjectPtr& object) {
  return assembled({object}).expression.leaves().size();
}

std::string error_of(const ObjectPtr& object) {
  try {
    assembled({object});
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

bool inside(const Object& object, Vec3d p);

bool inside_any(std::span<const ObjectPtr> objects, Vec3d p) {
  return std::any_of(objects.begin(), objects.end(),
                     [p](const ObjectPtr& part) { return inside(*part, p); });
}

/// What the operators mean, said once more: `p` is in the coordinates of what holds `object`.
bool inside(const Object& object, Vec3d p) {
  const Vec3d q = object.parent_from_object().inverse().point(p);
  if (const auto* shape = std::get_if<geometry::Solid>(&object.content)) return contains(*shape, q);
  const auto parts = parts_of(object).objects;
  if (!object.combination()) return inside_any(parts, q);
  switch (object.combination()->operation()) {
    case SetOperation::unite:
      return inside_any(parts, q);
    case SetOperation::intersect:
      return std::all_of(parts.begin(), parts.end(),
                         [q](const ObjectPtr& part) { return inside(*part, q); });
    case SetOperation::subtract:
    case SetOperation::section:
      return inside(*parts.front(), q) && !inside_any(parts.subspan(1), q);
    case SetOperation::complement:
      return !inside(*parts.front(), q);
  }
  return false;
}

bool inside(const Expression& expression, Expression::Term term, Vec3d p) {
  if (term.is_complement()) return !inside(expression, ~term, p);
  if (term.is_leaf()) return contains(expression.leaves()[term.index()].solid, p);
  const Expression::Node& node = expression.nodes()[term.index()];
  const auto holds = [&](Expression::Term operand) { return inside(expression, operand, p); };
  const auto operands = expression.operands(node);
  return node.operation == geometry::Operation::unite
             ? std::any_of(operands.begin(), operands.end(), holds)
             : std::all_of(operands.begin(), operands.end(), holds);
}

bool inside(const Solids& solids, const scene::SolidRegion& region, Vec3d p) {
  if (region.region.instance == geometry::Region::no_instance) {
    return inside(solids.expression, region.region.root, p);
  }
  const geometry::Instance& instance = solids.instances.at(region.region.instance);
  const geometry::Assembly& assembly = solids.assemblies.at(instance.assembly);
  return inside(assembly.expression, assembly.root,
                instance.world_from_assembly.inverse().point(p));
}

/// Makes solids of solids that it made before.
class RandomSolids {
 public:
  explicit RandomSolids(std::uint64_t seed) : random_(seed) {
    for (int i = 0; i < 6; ++i) {
      made_.push_back(ball());
      made_.push_back(solid(geometry::Box{{-1, -0.5, -1}, {0.5, 1, 1}}));
      made_.push_back(solid(geometry::Cylinder{{0, 0, -1}, {0, 1, 1}, 0.7}));
      made_.push_back(solid(geometry::HalfSpace{{}, point()}));
    }
  }

  ObjectPtr next() {
    ObjectPtr object = step();
    if (operand_count(*object) < 300) made_.push_back(object);
    return object;
  }
  Vec3d point() { return {coordinate(), coordinate(), coordinate()}; }

 private:
  double coordinate() { return random_.uniform(-2.0, 2.0); }
  const ObjectPtr& any() { return made_[random_.index(made_.size())]; }

  ObjectPtr step() {
    switch (random_.index(10)) {
      case 0:
        return moved(*any(), Transform::translation(point() * 0.5));
      case 1:
        return moved(*any(), Transform::rotation(point(), coordinate()));
      case 2:
        return complemented(any(), {});
      case 3:
        return make_combination(SetOperation::unite, {make_group({any(), any(), any()}, {})}, {});
      case 4:
        return with_section(any(), any());
      case 5:
      case 6:
        return unite(any(), any());
      case 7:
        return intersect(any(), any());
      default:
        return subtract(any(), any());
    }
  }

  Random random_;
  std::vector<ObjectPtr> made_;
};

TEST(Assemble, MeansWhatTheOperatorsSay) {
  RandomSolids random(7);
  std::size_t instances = 0;
  std::array<int, 2> found{};
  for (int round = 0; round < 400; ++round) {
    const ObjectPtr object = random.next(), knife = random.next();
    const ObjectPtr turned = moved(*object, Transform::rotation({1, 2, 3}, 1.0));
    const bool cut = round % 8 == 0;
    const Solids solids = assembled({object, turned}, cut ? knife : nullptr);
    ASSERT_EQ(solids.regions.size(), 2u);
    instances += solids.assemblies.size();
    for (int i = 0; i < 100; ++i) {
      const Vec3d p = random.point();
      const bool kept = !(cut && inside(*knife, p));
      ASSERT_EQ(inside(solids, solids.regions[0], p), kept && inside(*object, p)) << round;
      ASSERT_EQ(inside(solids, solids.regions[1], p), kept && inside(*turned, p)) << round;
      ++found[inside(*object, p)];
    }
  }
  EXPECT_GT(std::min(found[0], found[1]), 4000);
  EXPECT_GT(instances, 20u);
}

TEST(Assemble, StatesSharedPartsOnce) {
  const ObjectPtr shared = subtract(ball(), at(0.5, ball()));
  const ObjectPtr both = intersect(unite(shared, ball()), unite(shared, ball()));
  EXPECT_EQ(leaf_count(both), 4u);
  EXPECT_EQ(assembled({both}).expression.nodes().size(), 4u);
  const ObjectPtr aside = at(3, shared);
  EXPECT_EQ(leaf_count(unite(unite(shared, aside), subtract(ball(), aside))), 5u)
      << "again for another place, and once in that";
  EXPECT_EQ(leaf_count(unite(unite(shared, ball()), dressed(shared, matte(0.1)))), 5u)
      << "again for another surface";
}

TEST(Assemble, StatesTheBeginningThatVersionsShareOnce) {
  const ObjectPtr first = subtract(ball(), at(1, ball())), second = subtract(first, at(2, ball()));
  EXPECT_EQ(leaf_count(subtract(second, first)), 3u);
}

TEST(Assemble, StatesWhatStandsInSeveralPlacesOnce) {
  ObjectPtr large = ball(matte(0.3));
  for (int i = 0; i < 9; ++i) large = subtract(large, at(i, ball()));
  const ObjectPtr group = at(5, make_group({large, at(1, large)}, {}));
  const Solids solids = assembled({at(1, large), ball(), group});
  ASSERT_EQ(solids.assemblies.size(), 1u);
  EXPECT_EQ(solids.assemblies[0].expression.leaves().size(), 10u);
  EXPECT_EQ(solids.expression.leaves().size(), 1u);
  ASSERT_EQ(solids.regions.size(), 4u);
  EXPECT_EQ(solids.regions[1].region.instance, geometry::Region::no_instance);
  const auto x = [&](std::size_t i) {
    return solids.instances.at(solids.regions[i].region.instance).world_from_assembly.point({}).x;
  };
  EXPECT_EQ(x(0), 1);
  EXPECT_EQ(x(2), 5);
  EXPECT_EQ(x(3), 6);
}

TEST(Assemble, CopiesWhatIsSmallOrDiffers) {
  ObjectPtr large = ball(), small = ball();
  for (int i = 0; i < 9; ++i) large = subtract(large, at(i, ball()));
  for (int i = 0; i < 7; ++i) small = subtract(small, at(i, ball()));
  EXPECT_EQ(assembled({small, at(4, small)}).expression.leaves().size(), 16u);
  EXPECT_TRUE(assembled({large}).assemblies.empty());
  EXPECT_TRUE(assembled({large, at(3, large)}, ball()).assemblies.empty()) << "each is cut apart";
  EXPECT_TRUE(assembled({large, with_cut(large, Cut::Rule::inherit)}).assemblies.empty());
}

TEST(Assemble, WalksTowersOfAnyHeight) {
  ObjectPtr tower = ball();
  const ObjectPtr brick = ball();
  constexpr std::size_t height = 100'000;
  for (std::size_t i = 0; i < height; ++i) {
    tower = i % 2 ? unite(tower, brick) : subtract(tower, brick);
    if (i % 3 == 0) tower = dressed(tower, matte(0.5));
  }
  EXPECT_GE(assembled({tower}).expression.nodes().size(), height);
}

TEST(Assemble, RefusesMoreThanItMayHold) {
  ObjectPtr object = ball();
  for (int i = 0; i < 40; ++i) object = unite(object, at(std::ldexp(1.0, i), object));
  description::SceneDescription scene;
  scene.objects = {object};
  EXPECT_THROW(scene::assemble(scene, 1000), Error);
  ObjectPtr knot = ball();
  for (int i = 0; i < 40; ++i) knot = subtract(knot, unite(knot, ball()));
  scene.objects = {knot};
  EXPECT_LT(scene::assemble(scene, 1000).expression.leaves().size(), 100u) << "many, but the same";
}

TEST(Assemble, RefusesWhatItCannotCombine) {
  const auto sheet = std::make_shared<const Object>(
      Object{geometry::Sheet(geometry::Rectangle{}), nullptr, nullptr, nullptr, {}});
  EXPECT_THAT(error_of(subtract(ball(), sheet)), HasSubstr("a flat sheet encloses nothing"));
  const description::Mesh triangles{std::make_shared<const geometry::TriangleMesh>(square_mesh(1)),
                                    {}};
  const auto mesh =
      std::make_shared<const Object>(Object{triangles, nullptr, nullptr, nullptr, {}});
  EXPECT_THAT(error_of(subtract(ball(), mesh)), HasSubstr("the mesh bounds no volume"));
  EXPECT_THAT(error_of(with_section(mesh, ball())), HasSubstr("the mesh bounds no volume"));
  EXPECT_EQ(error_of(mesh), "no error");
}

TEST(Assemble, SparesLampsFromTheScenesSection) {
  const auto bulb = lamp(1.0);
  const Solids solids =
      assembled({ball(bulb), ball(), dressed(subtract(ball(), at(1, ball())), bulb),
                 unite(ball(), ball(bulb))},
                ball());
  EXPECT_TRUE(solids.regions[0].region.root.is_leaf());
  EXPECT_FALSE(solids.regions[1].region.root.is_leaf());
  EXPECT_EQ(solids.expression.nodes()[solids.regions[2].region.root.index()].count, 2u);
  // What glows in part is cut like everything else: its own node, with what is taken away.
  const auto& cut = solids.expression.nodes()[solids.regions[3].region.root.index()];
  EXPECT_EQ(cut.operation, geometry::Operation::intersect);
}

TEST(Assemble, KeepsTheOrderAndPlaceOfLoneSolids) {
  const Solids solids = assembled({ball(), at(4, ball())});
  ASSERT_EQ(solids.expression.leaves().size(), 2u);
  EXPECT_EQ(solids.regions[1].region.root.index(), 1u);
  EXPECT_EQ(bounds(solids.expression.leaves()[1].solid).center().x, 4);
}

ObjectPtr moving(const ObjectPtr& object) {
  return description::with_motion(*object, {{}, {}, {1, 1, 1}, {1, 0, 0}});
}

TEST(Assemble, MakesInstancesOfWhatMoves) {
  const ObjectPtr ball = solid(geometry::Sphere{}), cube = solid(geometry::Box{});
  const auto cut = description::combined(SetOperation::subtract, cube, ball, {});
  const Solids solids = assembled({moving(ball), ball, moving(cut), moving(cut)});
  ASSERT_EQ(solids.regions.size(), 4u);
  EXPECT_EQ(solids.regions[1].region.instance, geometry::Region::no_instance);
  for (const std::size_t i : {0u, 2u, 3u}) {
    const geometry::Instance& instance = solids.instances.at(solids.regions[i].region.instance);
    ASSERT_TRUE(instance.motion);
    EXPECT_NEAR(instance.motion->at(0.5).offset().x, 0.5, 1e-15);
  }
  EXPECT_EQ(solids.assemblies.size(), 2u) << "two of one design share it";
}

TEST(Assemble, RefusesPartsThatMoveByThemselves) {
  const ObjectPtr ball = solid(geometry::Sphere{}), cube = solid(geometry::Box{});
  EXPECT_THAT(error_of(description::combined(SetOperation::subtract, cube, moving(ball), {})),
              HasSubstr("what moves cannot be a part of a combination"));
  EXPECT_THAT(error_of(description::combined(SetOperation::unite, make_group({moving(ball)}, {}),
                                             cube, {})),
              HasSubstr("what moves cannot be a part of a combination"));
  EXPECT_THAT(error_of(moving(description::with_section(cube, ball))),
              HasSubstr("a section cannot cut what moves"));
  EXPECT_THAT(error_of(description::with_section(cube, moving(ball))),
              HasSubstr("what moves cannot be a part of a combination"));
  EXPECT_THROW(assembled({moving(ball)}, cube), Error);
}

TEST(Assemble, MeshesArePreparedOnceForScenesThatFollowEachOther) {
  scene::MeshSolids meshes;
  const auto cut = [](int levels) {
    const auto made = std::make_shared<const geometry::TriangleMesh>(ball_mesh(levels));
    const auto mesh = std::make_shared<const description::Object>(
        description::Object{description::Mesh{made, {}}, nullptr, nullptr, nullptr, {}});
    return subtract(mesh, ball());
  };
  // The mesh that was prepared: a scene's own one, or that of a scene before.
  const auto prepared = [&](int levels) {
    description::SceneDescription scene;
    scene.objects = {cut(levels)};
    const Solids solids = scene::assemble(scene, meshes);
    const auto& shape = solids.expression.leaves()[0].solid.solid();
    return std::get<geometry::MeshBody>(shape);
  };
  const geometry::MeshBody first = prepared(2);
  // Made anew, maybe at the address of one that is gone.
  for (int frame = 0; frame < 8; ++frame) EXPECT_EQ(&prepared(2).mesh(), &first.mesh());
  for (int frame = 0; frame < 8; ++frame) {
    const geometry::MeshBody other = prepared(3 + frame % 2);
    EXPECT_EQ(other.mesh(), ball_mesh(3 + frame % 2));
    EXPECT_NE(&other.mesh(), &first.mesh());
  }
  EXPECT_NE(&prepared(2).mesh(), &first.mesh()) << "dropped by the scenes without it";
}

}  // namespace
}  // namespace lapidary::test
