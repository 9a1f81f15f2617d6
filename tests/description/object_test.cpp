#include "description/object.h"

#include <gmock/gmock.h>

#include "construct.h"
#include "description/leaves.h"

namespace lapidary::description {
namespace {

using testing::ElementsAre;

class ObjectTest : public testing::Test {
 protected:
  Constructor make_;
  ObjectPtr ball_ = make_.object("sphere", "{name = 'ball'}");
  ObjectPtr cube_ = make_.object("box", "{size = {1, 1, 1}}");
  MaterialPtr red_ = make_.make<Material>("matte", "'red'");
  MaterialPtr blue_ = make_.make<Material>("matte", "'blue'");
};

TEST_F(ObjectTest, LeavesInheritFromTheirGroups) {
  const auto inner = with_material(*make_group({ball_, with_material(*cube_, blue_)}, {}), red_);
  const auto lifted = moved(*inner, Transform::translation({0, 0, 1}));
  const auto outer =
      moved(*with_name(*make_group({lifted, cube_}, {}), "all"), Transform::translation({1, 0, 0}));
  std::vector<std::string> names;
  std::vector<MaterialPtr> materials;
  std::vector<Vec3d> origins;
  for_each_leaf({&outer, 1}, [&](const Leaf& leaf) {
    names.emplace_back(leaf.name);
    materials.push_back(leaf.material);
    origins.push_back(leaf.world_from_object.point({0, 0, 0}));
  });
  EXPECT_THAT(names, ElementsAre("ball", "all", "all"));
  EXPECT_THAT(materials, ElementsAre(red_, blue_, default_material()));
  EXPECT_THAT(origins, ElementsAre(Vec3d(1, 0, 1), Vec3d(1, 0, 1), Vec3d(1, 0, 0)));
}

// A wheel that turns once about its hub on a cart that rolls on, seen from a turned world.
TEST_F(ObjectTest, MotionsNest) {
  geometry::Motion spin, roll;
  spin.turn = {{0, 1, 0}, 2 * pi};
  roll.travel = {4, 0, 0};
  const auto rim = moved(*cube_, Transform::translation({1, 0, 0}));
  const auto wheel = with_motion(*make_group({rim, ball_}, {}), spin);
  const auto cart =
      with_motion(*make_group({moved(*wheel, Transform::translation({0, 0, 1})), cube_}, {}), roll);
  const auto turned = moved(*cart, Transform::rotation({0, 0, 1}, 0.5 * pi));
  const ObjectPtr objects[] = {turned, cube_};
  std::vector<std::shared_ptr<const geometry::MovingTransform>> motions;
  for_each_leaf(objects, [&](const Leaf& leaf) {
    motions.push_back(leaf.motion);
    if (!leaf.motion) return;
    for (const Vec3d& p : {Vec3d{}, Vec3d{1, 2, 3}}) {
      EXPECT_LT(length(leaf.motion->at(0).point(p) - leaf.world_from_object.point(p)), 1e-14);
    }
  });
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_FALSE(motions[3]);
  const auto where = [&](std::size_t leaf, double time) {
    return motions[leaf]->at(time).point({});
  };
  // The rim goes backwards over the hub, by a quarter of a turn: from (1, 0, 1) down to (0, 0, 0),
  // while the cart has gone 1; x of the cart is y of the world.
  EXPECT_LT(length(where(0, 0.25) - Vec3d(0, 1, 0)), 1e-14);
  EXPECT_LT(length(where(1, 0.25) - Vec3d(0, 1, 1)), 1e-14);
  EXPECT_LT(length(where(2, 0.75) - Vec3d(0, 3, 0)), 1e-14);
}

TEST_F(ObjectTest, CopiesShareWhatTheyHaveInCommon) {
  const auto group = make_group({ball_, cube_}, {});
  const auto copy = moved(*group, Transform::translation({1, 0, 0}));
  EXPECT_EQ(std::get<std::shared_ptr<const Group>>(group->content),
            std::get<std::shared_ptr<const Group>>(copy->content));
}

TEST_F(ObjectTest, AMaterialReplacesThoseOfAMesh) {
  Object mesh;
  mesh.content = Mesh{std::make_shared<const geometry::TriangleMesh>(), {red_, blue_}};
  const auto dressed = with_material(mesh, red_);
  EXPECT_TRUE(std::get<Mesh>(dressed->content).materials.empty());
  EXPECT_EQ(dressed->material, red_);
}

TEST_F(ObjectTest, GroupsNestOnlySoDeep) {
  ObjectPtr object = ball_;
  for (int i = 0; i < max_group_depth; ++i) object = make_group({object}, {});
  EXPECT_THROW(make_group({object}, {}), Error);
}

TEST_F(ObjectTest, AreSmall) {
  // A million of them must fit beside their tables: 500 bytes each with all that Lua adds.
  EXPECT_LE(sizeof(Object), 224u);
}

}  // namespace
}  // namespace lapidary::description
