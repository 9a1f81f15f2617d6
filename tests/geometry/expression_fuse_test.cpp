// Half-spaces fused to polyhedra against the same half-spaces one by one, to the bit.

#include <gtest/gtest.h>

#include "geometry/curved_models.h"

namespace lapidary::test {
namespace {

using namespace geometry;
using csg::CurvedModel;
using csg::CurvedModels;
using Term = Expression::Term;

struct Seen {
  double t;
  Vec3d normal;  ///< out of the body
  bool enters;
  std::uint32_t leaf;  ///< as stated
  bool operator==(const Seen&) const = default;
};

/// Leaves below `first_leaf` count as one: some of them have the same content.
std::vector<Seen> seen(const SolidScene& scene, const Ray& ray, std::size_t first_leaf) {
  std::vector<Seen> list;
  for (const Transition& t : csg::sweep_all(scene, ray)) {
    const Vec3d n = scene.outward_normal(t.place, t.leaf, t.patch, ray.line().at(t.t));
    const std::uint32_t leaf = scene.world().stated_leaf(t.leaf, t.patch);
    list.push_back({t.t, t.is_complement ? -n : n, t.after != SolidScene::no_region,
                    leaf < first_leaf ? 0 : leaf});
  }
  return list;
}

/// Planes about the origin at up to 1.5 from it: a cube about it and whatever cuts that.
std::vector<HalfSpace> convex_body(Random& random) {
  std::vector<HalfSpace> planes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Vec3d n;
      n[axis] = sign;
      planes.push_back({n * (0.25 * static_cast<double>(2 + random.index(4))), n});
    }
  }
  for (std::size_t more = random.index(30); more > 0; --more) {
    const Vec3d n = random.direction();
    planes.push_back({n * random.uniform(0.5, 1.5), n * random.uniform(0.1, 9)});
  }
  return planes;
}

enum class Wearing : std::uint8_t { same, different };

/// A convex body, combined with a model.
struct Stated {
  Expression expression;
  Term convex, root;
};

Stated stated(const std::vector<HalfSpace>& planes, const CurvedModel& model, const Transform& map,
              Wearing wearing, std::size_t how) {
  Stated s{model.placed(map), {}, {}};
  std::vector<Term> terms;
  for (const HalfSpace& plane : planes) {
    const auto tag = wearing == Wearing::same ? 7u : static_cast<SurfaceTag>(terms.size());
    terms.push_back(s.expression.add(PlacedSolid(plane, map), tag));
  }
  s.convex = s.expression.add(Operation::intersect, terms);
  const Term a = how / 2 % 2 == 0 ? s.convex : ~s.convex;
  const Term b = how / 4 % 2 == 0 ? model.root : ~model.root;
  const Term both[]{a, b};
  s.root = s.expression.add(how % 2 == 0 ? Operation::unite : Operation::intersect, both);
  return s;
}

Transform mirror() {
  return Transform::translation({1, -2, 0.5}) * Transform::rotation({1, 2, 3}, 1.1) *
         Transform::scaling({-1, 1, 1});
}

const Transform maps[]{{},
                       Transform::translation({0.1, 0.2, -0.7}),
                       csg::odd_turn(3, {5, 6, 7}),
                       csg::odd_placement(),
                       mirror()};

/// How many of the planes pass through a point of the world, or as near as matters.
std::size_t planes_through(const std::vector<HalfSpace>& planes, const Transform& map, Vec3d p) {
  return static_cast<std::size_t>(std::ranges::count_if(planes, [&](const HalfSpace& plane) {
    const Vec3d n = normalize(map.normal(plane.normal));
    return std::abs(dot(p - map.point(plane.point), n)) < 1e-9;
  }));
}

TEST(ExpressionFuse, ChangesNoBitOfWhatLinesMeet) {
  CurvedModels models(61);
  std::size_t compared = 0, edges = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    const std::vector<HalfSpace> planes = convex_body(models.random());
    const CurvedModel model = models.model(2);
    const Transform& map = maps[i % std::size(maps)];
    Stated one = stated(planes, model, map, Wearing::same, i / std::size(maps));
    Stated many = stated(planes, model, map, Wearing::different, i / std::size(maps));
    const SolidScene fused = csg::body(std::move(one.expression), one.root);
    const SolidScene single = csg::body(std::move(many.expression), many.root);
    ASSERT_GT(fused.world().leaves().size(), fused.world().stated_leaves());
    ASSERT_EQ(fused.leaf_count(), single.leaf_count());
    for (int j = 0; j < 60; ++j) {
      const Ray ray = csg::moved(map, models.ray());
      const auto expected = seen(single, ray, model.leaves.size());
      const auto found = seen(fused, ray, model.leaves.size());
      ASSERT_EQ(found.size(), expected.size()) << "body " << i << " ray " << j;
      for (std::size_t k = 0; k < found.size(); ++k) {
        const bool on_edge = planes_through(planes, map, ray.line().at(found[k].t)) > 1;
        ++(on_edge ? edges : compared);
        ASSERT_EQ(found[k].enters, expected[k].enters);
        ASSERT_NEAR(found[k].t, expected[k].t, 1e-9);
        ASSERT_TRUE(on_edge || found[k] == expected[k]) << "body " << i << " ray " << j;
      }
    }
  }
  EXPECT_GT(compared, 8000u);
  EXPECT_GT(edges, 50u);
}

/// The planes in another order and in other words.
SolidScene restated(std::vector<HalfSpace> planes, const Transform& map, Random& random) {
  for (std::size_t i = planes.size(); i > 1; --i) {
    std::swap(planes[i - 1], planes[random.index(i)]);
  }
  Expression expression;
  std::vector<Term> terms;
  for (const HalfSpace& plane : planes) terms.push_back(expression.add(PlacedSolid(plane, map)));
  while (terms.size() > 1) {
    const std::size_t i = random.index(terms.size() - 1);
    const bool negated = random.index(2) == 0;
    const Term pair[]{negated ? ~terms[i] : terms[i], negated ? ~terms[i + 1] : terms[i + 1]};
    const Term both = expression.add(negated ? Operation::unite : Operation::intersect, pair);
    terms[i] = negated ? ~both : both;
    terms.erase(terms.begin() + static_cast<std::ptrdiff_t>(i) + 1);
  }
  return csg::body(std::move(expression), terms.front());
}

TEST(ExpressionFuse, TakesBracketsOrderAndDeMorganAsTheSame) {
  CurvedModels models(62);
  for (std::size_t i = 0; i < 100; ++i) {
    const std::vector<HalfSpace> planes = convex_body(models.random());
    const Transform& map = maps[i % std::size(maps)];
    const SolidScene a = restated(planes, map, models.random());
    const SolidScene b = restated(planes, map, models.random());
    ASSERT_EQ(a.world().leaves().size(), planes.size() + 1);
    ASSERT_EQ(b.world().leaves().size(), planes.size() + 1);
    ASSERT_EQ(a.world().live_leaves(), planes.size());
    for (int j = 0; j < 40; ++j) {
      const Ray ray = csg::moved(map, models.ray());
      // Their order is what differs.
      ASSERT_EQ(seen(a, ray, planes.size()), seen(b, ray, planes.size()))
          << "body " << i << " ray " << j;
    }
  }
}

// The exact image of a needle's tip is far from where its planes, rounded, meet.
TEST(ExpressionFuse, BoundsHoldEveryCornerOfTheExactImage) {
  const double slope = 1e-5;
  const Vec3d far{1e5 + 0.1, -3e5 - 0.7, 0.3};
  const HalfSpace planes[]{{{0, 0, 0}, {-1, 0, 0}},
                           {{0, 1, 0}, {slope, 1, 0}},
                           {{0, -1, 0}, {slope, -1, 0}},
                           {{0, 0, 1}, {0, 0, 1}},
                           {{0, 0, -1}, {0, 0, -1}}};
  std::vector<PlacedSolid> placed;
  for (const HalfSpace& h : planes) placed.emplace_back(h, Transform::translation(far));
  const auto fused = PlacedSolid::fused(placed);
  ASSERT_TRUE(fused);
  const Box3d box = bounds(*fused);
  ASSERT_TRUE(box.bounded());
  EXPECT_GE(box.max.x, far.x + 1 / slope);
  EXPECT_LE(box.max.x, far.x + 1 / slope + 0.01);
  EXPECT_LE(box.min.x, far.x);
}

/// How many leaves a body has more than were stated.
std::size_t fused_count(Expression expression, std::initializer_list<Term> roots) {
  const std::size_t stated = expression.leaves().size();
  expression.fuse_half_spaces(std::vector<Term>(roots));
  return expression.leaves().size() - stated;
}

struct Cube {
  Expression expression;
  std::vector<Term> faces;

  explicit Cube(const Transform& of_last = {}, SurfaceTag of_first = inherited_surface) {
    for (std::size_t i = 0; i < 6; ++i) {
      Vec3d n;
      n[i % 3] = i < 3 ? 1 : -1;
      faces.push_back(expression.add(PlacedSolid(HalfSpace{n, n}, i == 5 ? of_last : Transform()),
                                     i == 0 ? of_first : inherited_surface));
    }
  }
  Term intersection() { return expression.add(Operation::intersect, faces); }
};

TEST(ExpressionFuse, LeavesAloneWhatIsUsedElsewhere) {
  Cube plain, shared_face, repeated, root_face;
  const Term cube = plain.intersection();
  EXPECT_EQ(fused_count(plain.expression, {cube}), 1u);
  const Term of_shared = shared_face.intersection();
  const Term face[]{shared_face.faces[2]};
  const Term second = shared_face.expression.add(Operation::unite, face);
  EXPECT_EQ(fused_count(shared_face.expression, {of_shared, second}), 0u);
  const Term body = root_face.intersection();
  EXPECT_EQ(fused_count(root_face.expression, {body, root_face.faces[4]}), 0u);
  // Used by another node, but as a whole: it is one operation by itself.
  const Term twice = repeated.intersection();
  const Term user[]{twice, ~twice};
  const Term both = repeated.expression.add(Operation::unite, user);
  EXPECT_EQ(fused_count(repeated.expression, {both}), 1u);
}

TEST(ExpressionFuse, LeavesAloneWhatIsUnboundedOrDiffers) {
  Cube worn({}, 3), turned(csg::odd_placement()), open, joined, outside;
  const Term one = worn.intersection(), two = turned.intersection();
  EXPECT_EQ(fused_count(worn.expression, {one}), 0u) << "five faces bound nothing";
  EXPECT_EQ(fused_count(turned.expression, {two}), 0u);
  open.faces.pop_back();
  const Term three = open.intersection();
  EXPECT_EQ(fused_count(open.expression, {three}), 0u);
  const Term four = joined.expression.add(Operation::unite, joined.faces);
  EXPECT_EQ(fused_count(joined.expression, {four}), 0u);
  for (Term& face : outside.faces) face = ~face;
  const Term five = outside.intersection();
  EXPECT_EQ(fused_count(outside.expression, {five}), 0u);
}

// Beyond 512 the search for faces would take too long, below 4 nothing is bounded.
TEST(ExpressionFuse, HasALimit) {
  for (const std::size_t count : {512u, 513u}) {
    Random random(63);
    Expression expression;
    std::vector<Term> terms;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3d n = random.direction();
      terms.push_back(expression.add(PlacedSolid(HalfSpace{n, n}, {})));
    }
    const Term root = expression.add(Operation::intersect, terms);
    EXPECT_EQ(fused_count(std::move(expression), {root}), count == 512 ? 1u : 0u);
  }
}

}  // namespace
}  // namespace lapidary::test
