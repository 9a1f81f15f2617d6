#include <set>

#include <gmock/gmock.h>

#include "base/error.h"
#include "scene/assemble.h"
#include "scene/solid_builders.h"
#include "scene/tiny_scene.h"

namespace lapidary::test {
namespace {

using description::Cut;
using description::make_group;
using description::MaterialPtr;
using description::ObjectPtr;
using geometry::Expression;
using scene::Solids;
using testing::ElementsAre;
using testing::HasSubstr;

/// What the leaves of solids wear, and what fills solids.
class Wearing : public testing::Test {
 protected:
  static Solids assembled(std::vector<ObjectPtr> objects, ObjectPtr section = nullptr) {
    description::SceneDescription scene;
    scene.objects = std::move(objects);
    scene.section = std::move(section);
    return scene::assemble(scene);
  }

  /// The materials of all leaves of a scene of one object, in the order of writing.
  static std::vector<MaterialPtr> worn(const ObjectPtr& object, ObjectPtr section = nullptr) {
    const Solids solids = assembled({object}, std::move(section));
    std::vector<MaterialPtr> materials;
    for (const Expression::Leaf& leaf : solids.expression.leaves()) {
      const bool inherits = leaf.tag == geometry::inherited_surface;
      const geometry::SurfaceTag tag = inherits ? solids.regions.at(0).region.tag : leaf.tag;
      materials.push_back(solids.slots.at(tag).material);
    }
    return materials;
  }

  static std::uint32_t medium(const Solids& solids, std::size_t i) {
    return solids.regions.at(i).region.medium;
  }
  static MaterialPtr filling(const ObjectPtr& object) {
    const Solids solids = assembled({object});
    return solids.media.at(medium(solids, 0));
  }
  static ObjectPtr filled(const ObjectPtr& object, MaterialPtr interior) {
    return with_attributes(*object, {.interior = std::move(interior)});
  }
  static MaterialPtr tinted(float share) {
    description::Glass clear;
    clear.absorption = description::Absorption{Spectrum::constant(share), 2.0};
    return material(clear);
  }

  MaterialPtr red_ = matte(0.1), green_ = matte(0.2), blue_ = matte(0.3),
              plain_ = description::default_material();
  MaterialPtr crown_ = glass("N-BK7"), water_ = glass("water");
};

TEST_F(Wearing, TheLeafsOwnOrWhatIsAround) {
  EXPECT_THAT(worn(unite(ball(), ball(red_))), ElementsAre(plain_, red_));
  EXPECT_THAT(worn(dressed(unite(ball(), ball(red_)), blue_)), ElementsAre(blue_, red_));
  const ObjectPtr inner = dressed(unite(ball(), ball()), green_);
  EXPECT_THAT(worn(dressed(intersect(inner, ball()), blue_)), ElementsAre(green_, green_, blue_));
  EXPECT_THAT(worn(dressed(make_group({subtract(ball(), ball())}, {}), blue_)),
              ElementsAre(blue_, blue_));
}

TEST_F(Wearing, CutsWearTheCuttersOrWhatIsCut) {
  EXPECT_THAT(worn(subtract(ball(red_), ball())), ElementsAre(red_, red_));
  EXPECT_THAT(worn(subtract(ball(red_), ball(green_))), ElementsAre(red_, green_));
  EXPECT_THAT(worn(dressed(subtract(ball(), ball()), blue_)), ElementsAre(blue_, blue_));
  EXPECT_THAT(worn(dressed(subtract(ball(red_), ball()), blue_)), ElementsAre(red_, blue_));
  const ObjectPtr drilled = subtract(ball(red_), ball());
  EXPECT_THAT(worn(subtract(at(1, drilled), unite(ball(), ball(green_)))),
              ElementsAre(red_, red_, red_, green_));
  EXPECT_THAT(worn(dressed(unite(drilled, ball()), green_)), ElementsAre(red_, red_, green_));
  const ObjectPtr painted = dressed(unite(ball(), ball(red_)), blue_);
  EXPECT_THAT(worn(subtract(painted, ball())), ElementsAre(blue_, red_, blue_));
  EXPECT_THAT(worn(subtract(ball(red_), subtract(ball(green_), ball()))),
              ElementsAre(red_, green_, green_));
}

TEST_F(Wearing, CutsWearWhatTheyAreTold) {
  const ObjectPtr drilled = subtract(ball(red_), ball(green_));
  EXPECT_THAT(worn(with_cut(drilled, Cut::Rule::inherit)), ElementsAre(red_, red_));
  EXPECT_THAT(worn(with_cut(drilled, Cut::Rule::material, blue_)), ElementsAre(red_, blue_));
  EXPECT_THAT(worn(with_cut(make_group({drilled}, {}), Cut::Rule::inherit)),
              ElementsAre(red_, red_));
  const ObjectPtr stubborn = with_cut(drilled, Cut::Rule::cutter);
  EXPECT_THAT(worn(with_cut(make_group({stubborn}, {}), Cut::Rule::inherit)),
              ElementsAre(red_, green_));
  const ObjectPtr cutter = unite(ball(green_), subtract(ball(green_), ball(blue_)));
  EXPECT_THAT(worn(with_cut(subtract(ball(red_), cutter), Cut::Rule::inherit)),
              ElementsAre(red_, red_, red_, red_));
}

TEST_F(Wearing, SectionsMarkTheirFaces) {
  EXPECT_THAT(worn(with_section(ball(red_), ball(blue_))), ElementsAre(red_, blue_));
  EXPECT_THAT(worn(with_section(ball(red_), ball())), ElementsAre(red_, red_));
  const ObjectPtr drilled = subtract(ball(red_), ball(green_));
  EXPECT_THAT(worn(drilled, ball(blue_)), ElementsAre(red_, green_, blue_));
  EXPECT_THAT(worn(drilled, ball()), ElementsAre(red_, green_, red_));
  EXPECT_THAT(worn(with_section(with_cut(drilled, Cut::Rule::inherit), ball(blue_))),
              ElementsAre(red_, red_, blue_))
      << "what drills leave is another matter";
  EXPECT_THAT(worn(unite(with_section(ball(red_), ball(blue_)), ball(green_))),
              ElementsAre(red_, blue_, green_));
}

TEST_F(Wearing, EveryObjectHasSlotsOfItsOwn) {
  const Solids solids = assembled({ball(red_), unite(ball(red_), ball(red_)), ball(red_)});
  ASSERT_EQ(solids.regions.size(), 3u);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(solids.regions[i].object, i);
  const auto& leaves = solids.expression.leaves();
  EXPECT_EQ(leaves[1].tag, leaves[2].tag);
  EXPECT_EQ(solids.slots.at(leaves[1].tag).object, 1u);
  EXPECT_EQ(solids.slots.at(leaves[1].tag).material, red_);
}

// Sheets and meshes are objects, too, but no solids.
TEST_F(Wearing, ObjectsAreCountedAll) {
  TinyScene tiny;
  tiny.add(geometry::Rectangle{}, red_).add_mesh(square_mesh(1), red_);
  tiny.add(geometry::Sphere{}, green_);
  const Solids solids = scene::assemble(tiny.description);
  ASSERT_EQ(solids.regions.size(), 1u);
  EXPECT_EQ(solids.regions[0].object, 2u);
  EXPECT_EQ(solids.slots.at(solids.regions[0].region.tag).object, 2u);
}

TEST_F(Wearing, EqualGlassIsOneMedium) {
  const Solids solids =
      assembled({ball(glass("N-BK7")), ball(glass("N-BK7", 0.2)), ball(water_), ball(tinted(0.5f)),
                 ball(tinted(0.5f)), ball(tinted(0.6f)), ball(glass(1.5))});
  EXPECT_EQ(medium(solids, 0), medium(solids, 1));
  EXPECT_EQ(medium(solids, 3), medium(solids, 4));
  std::set<std::uint32_t> media;
  for (const auto& region : solids.regions) {
    media.insert(region.region.medium);
    EXPECT_EQ(region.region.opacity, geometry::Opacity::transparent);
  }
  EXPECT_EQ(media, (std::set<std::uint32_t>{1, 2, 3, 4, 5}));
  ASSERT_EQ(solids.media.size(), 6u);
  EXPECT_EQ(solids.media[0], nullptr);
  EXPECT_TRUE(std::get<description::Glass>(solids.media[3]->model).absorption.has_value());
}

TEST_F(Wearing, OpaqueMaterialsAreMediaOfTheirOwn) {
  const Solids solids = assembled({ball(red_), ball(green_), ball(red_), ball()});
  EXPECT_EQ(medium(solids, 0), medium(solids, 2));
  EXPECT_NE(medium(solids, 0), medium(solids, 1));
  EXPECT_NE(medium(solids, 3), 0u);
  EXPECT_EQ(solids.regions[0].region.opacity, geometry::Opacity::opaque);
}

TEST_F(Wearing, TheInteriorNeedNotBeTheSurface) {
  const auto pond = with_attributes(*ball(red_), {.interior = water_, .priority = 4});
  const Solids solids =
      assembled({pond, ball(water_), filled(make_group({ball(red_)}, {}), water_)});
  EXPECT_EQ(medium(solids, 0), medium(solids, 1));
  EXPECT_EQ(medium(solids, 2), medium(solids, 1));
  EXPECT_EQ(solids.regions[0].region.opacity, geometry::Opacity::transparent);
  EXPECT_EQ(solids.regions[0].region.priority, 4);
  EXPECT_EQ(solids.regions[1].region.priority, 0);
  EXPECT_EQ(solids.slots.at(solids.regions[0].region.tag).material, red_);
}

TEST_F(Wearing, CombinationsAreFilledAsTheirPartsAgree) {
  EXPECT_EQ(filling(subtract(ball(crown_), ball(red_))), crown_);
  EXPECT_EQ(filling(intersect(ball(crown_), ball(crown_))), crown_);
  EXPECT_EQ(filling(dressed(intersect(ball(crown_), ball()), water_)), water_);
  EXPECT_EQ(filling(intersect(ball(crown_), complemented(ball(red_), {}))), crown_);
  EXPECT_EQ(filling(unite(subtract(ball(crown_), ball()), filled(ball(red_), crown_))), crown_);
  EXPECT_EQ(filling(unite(ball(red_), ball(green_))), red_);
  EXPECT_EQ(filling(filled(unite(ball(red_), ball(crown_)), water_)), water_);
  for (const auto& other : {ball(red_), ball(), ball(water_)}) {
    try {
      filling(unite(ball(crown_), other));
      FAIL();
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("disagree about what fills it"));
    }
  }
}

}  // namespace
}  // namespace lapidary::test
