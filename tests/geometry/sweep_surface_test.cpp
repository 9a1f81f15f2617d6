// Which of several surfaces at one place shows: among those whose change makes the body's, a
// positive operand before a negative one, then the one stated first; of bodies the opaque one, then
// the one of greater priority.

#include <gtest/gtest.h>

#include "geometry/curved_models.h"

namespace lapidary::test {
namespace {

using namespace geometry;
using Term = Expression::Term;

enum Tag : SurfaceTag { own = 1, red, blue, other_own };

/// Boxes of one height between z = 0 and 1, that stand by different maps: their faces coincide but
/// for rounding.
class Shop {
 public:
  explicit Shop(const Transform& map) : map_(map) {}

  Expression expression;

  Term slab(double half, double low, double high, SurfaceTag tag = inherited_surface) {
    const double z = 1.0 / 3 + static_cast<double>(count_++);
    const Transform lift = map_ * Transform::translation({0, 0, z});
    return expression.add(PlacedSolid(Box{{-half, -half, low - z}, {half, half, high - z}}, lift),
                          tag);
  }
  Term rod(double radius, double low, double high, SurfaceTag tag) {
    return expression.add(PlacedSolid(Cylinder{{0, 0, low}, {0, 0, high}, radius}, map_), tag);
  }
  Term unite(Term a, Term b) { return combine(Operation::unite, a, b); }
  Term subtract(Term a, Term b) { return combine(Operation::intersect, a, ~b); }

 private:
  Term combine(Operation operation, Term a, Term b) {
    const Term both[]{a, b};
    return expression.add(operation, both);
  }
  Transform map_;
  int count_ = 0;
};

const Transform places[]{{},
                         Transform::translation({0.1, 0.7, -0.3}),
                         csg::odd_turn(1.7, {3, 1, 2}),
                         csg::odd_placement()};

/// From above, down along z at x, y.
Ray down(const Transform& map, double x, double y) {
  return csg::moved(map, Ray{{x, y, 5}, {0, 0, -1}});
}
Ray up(const Transform& map, double x, double y) {
  return csg::moved(map, Ray{{x, y, -5}, {0, 0, 1}});
}

SolidScene one_body(Shop& shop, Term root) {
  Region region;
  region.root = root, region.medium = 1, region.tag = own;
  return SolidScene({std::move(shop.expression), {}, {}, {region}});
}

std::vector<SurfaceTag> tags(const SolidScene& scene, const Ray& ray) {
  std::vector<SurfaceTag> list;
  for (const Transition& t : csg::sweep_all(scene, ray)) list.push_back(t.tag);
  return list;
}

using Tags = std::vector<SurfaceTag>;

TEST(SweepSurface, APlugFlushInADrilledPlateShowsItself) {
  for (const Transform& map : places) {
    Shop shop(map);
    const Term plate = shop.slab(2, 0, 1), hole = shop.rod(0.5, 0, 1, blue);
    const Term drilled = shop.subtract(plate, hole);
    const SolidScene scene = one_body(shop, shop.unite(drilled, shop.rod(0.5, 0, 1, red)));
    for (const Ray& ray : {down(map, 0.1, 0.2), up(map, 0.1, 0.2)}) {
      EXPECT_EQ(tags(scene, ray), (Tags{red, red}));
    }
    EXPECT_EQ(tags(scene, down(map, 1, 0.2)), (Tags{own, own}));
    // Through plate and plug from the side nothing of what they touch in.
    EXPECT_EQ(tags(scene, csg::moved(map, Ray{{-5, 0.1, 0.5}, {1, 0, 0}})), (Tags{own, own}));
  }
}

// A plug in a plate that has no hole: both are positive, the plate was stated first.
TEST(SweepSurface, OfEqualSignTheFirstStatedShows) {
  for (const Transform& map : places) {
    for (const bool plug_first : {false, true}) {
      Shop shop(map);
      Term plate, plug;
      if (plug_first) plug = shop.rod(0.5, 0, 1, red);
      plate = shop.slab(2, 0, 1, blue);
      if (!plug_first) plug = shop.rod(0.5, 0, 1, red);
      const SolidScene scene = one_body(shop, shop.unite(plug, plate));
      const SurfaceTag shown = plug_first ? red : blue;
      EXPECT_EQ(tags(scene, down(map, 0.1, 0.2)), (Tags{shown, shown}));
      EXPECT_EQ(tags(scene, down(map, 1, 0.2)), (Tags{blue, blue}));
    }
  }
}

// Two pockets with a common floor wear different colours where only one of them is, and where they
// overlap that of the cutter stated first, whatever the order of the cuts.
TEST(SweepSurface, OfCoincidentCuttersTheFirstStatedShows) {
  for (const Transform& map : places) {
    for (const bool swapped : {false, true}) {
      Shop shop(map);
      const Term plate = shop.slab(2, 0, 1);
      const Term wide = shop.slab(1, 0.5, 2, red), narrow = shop.slab(0.5, 0.5, 3, blue);
      const Term a = swapped ? narrow : wide, b = swapped ? wide : narrow;
      const SolidScene scene = one_body(shop, shop.subtract(shop.subtract(plate, a), b));
      EXPECT_EQ(tags(scene, down(map, 0.1, 0.2)), (Tags{red, own}));
      EXPECT_EQ(tags(scene, down(map, 0.8, 0.2)), (Tags{red, own}));
    }
  }
}

// The floor of a pocket is the top of an inlay: positive before negative, whatever came first.
TEST(SweepSurface, PositiveShowsBeforeNegative) {
  for (const Transform& map : places) {
    for (const bool cutter_first : {false, true}) {
      Shop shop(map);
      Term cutter;
      if (cutter_first) cutter = shop.slab(0.5, 0.5, 2, blue);
      const Term plate = shop.slab(2, 0, 1), inlay = shop.slab(1, 0.2, 0.5, red);
      if (!cutter_first) cutter = shop.slab(0.5, 0.5, 2, blue);
      const SolidScene scene = one_body(shop, shop.unite(shop.subtract(plate, cutter), inlay));
      EXPECT_EQ(tags(scene, down(map, 0.1, 0.2)), (Tags{red, own}));
      EXPECT_EQ(tags(scene, up(map, 0.1, 0.2)), (Tags{own, red}));
    }
  }
}

TEST(SweepSurface, FacesOfTheSameTagLeaveNoSkin) {
  for (const Transform& map : places) {
    Shop shop(map);
    const Term lower = shop.slab(1, 0, 1, red), upper = shop.slab(1, 1, 2, red);
    const SolidScene scene = one_body(shop, shop.unite(lower, upper));
    EXPECT_EQ(tags(scene, down(map, 0.1, 0.2)), (Tags{red, red}));
  }
}

/// Two bodies on top of each other, the first of them glass, and the face between them.
Transition contact(const Transform& map, bool glass_first, Opacity second, const Ray& ray) {
  Shop shop(map);
  std::vector<Region> regions(2);
  const Term glass = shop.slab(1, 1, 2, red), other = shop.slab(1, 0, 1, blue);
  regions[0].root = glass, regions[0].medium = 1, regions[0].tag = own;
  regions[0].opacity = Opacity::transparent;
  regions[1].root = other, regions[1].medium = 2, regions[1].tag = other_own;
  regions[1].opacity = second;
  if (!glass_first) std::swap(regions[0], regions[1]);
  const SolidScene scene({std::move(shop.expression), {}, {}, regions});
  const auto found = csg::sweep_all(scene, ray);
  EXPECT_EQ(found.size(), 3u);
  return found.size() == 3 ? found[1] : Transition{};
}

TEST(SweepSurface, GlassThatTouchesSomethingOpaqueShowsThat) {
  for (const Transform& map : places) {
    for (const bool glass_first : {false, true}) {
      for (const Ray& ray : {down(map, 0.1, 0.2), up(map, 0.1, 0.2)}) {
        const Transition t = contact(map, glass_first, Opacity::opaque, ray);
        EXPECT_EQ(t.tag, blue);
        EXPECT_EQ(t.surface_of, glass_first ? 1u : 0u) << "of the opaque one";
      }
    }
  }
}

TEST(SweepSurface, OfTwoGlassesTheFirstStatedShows) {
  for (const Transform& map : places) {
    for (const bool glass_first : {false, true}) {
      for (const Ray& ray : {down(map, 0.1, 0.2), up(map, 0.1, 0.2)}) {
        const Transition t = contact(map, glass_first, Opacity::transparent, ray);
        EXPECT_EQ(t.tag, glass_first ? red : blue);
        EXPECT_EQ(t.surface_of, 0u);
      }
    }
  }
}

// Half-spaces that are fused to one leaf keep their numbers in the order of writing.
TEST(SweepSurface, FusedHalfSpacesKeepTheirPlaceInTheOrder) {
  for (const Transform& map : places) {
    for (const std::size_t box_at : {std::size_t{0}, std::size_t{2}, std::size_t{6}}) {
      Shop shop(map);
      std::vector<Term> cube;
      Term box;
      for (std::size_t i = 0; i <= 6; ++i) {
        if (i == box_at) box = shop.slab(2, -1, 1, blue);
        if (i == 6) break;
        Vec3d n;
        n[i % 3] = i < 3 ? 1 : -1;  // the third is its top, at z = 1
        cube.push_back(shop.expression.add(PlacedSolid(HalfSpace{n, n}, map), red));
      }
      const Term whole = shop.expression.add(Operation::intersect, cube);
      const SolidScene scene = one_body(shop, shop.unite(whole, box));
      ASSERT_EQ(scene.world().leaves().size(), 8u);
      EXPECT_EQ(tags(scene, down(map, 0.1, 0.2)).front(), box_at > 2 ? red : blue);
    }
  }
}

}  // namespace
}  // namespace lapidary::test
