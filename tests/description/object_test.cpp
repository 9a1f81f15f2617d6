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
