#include "geometry/compound_surface.h"

#include <algorithm>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/compound_area.h"
#include "geometry/expression_part.h"
#include "geometry/sweep.h"
#include "support/chi_squared.h"
#include "support/random.h"
#include "support/statistics.h"

namespace lapidary::geometry {
namespace {

using lapidary::test::Random;
using lapidary::test::RunningMean;

constexpr SeenSides both_sides{true, true};

/// z >= x^2 + y^2, without bounds.
PlacedSolid paraboloid(const Transform& placement = {}) {
  const QuadraticForm form{{1, 1, 0}, {}, {0, 0, -1}, 0};
  return {Quadric{std::make_shared<const QuadraticForm>(form)}, placement};
}

std::optional<LeafPoint> draw(const LeafSurface& surface, Random& random,
                              const std::optional<Vec3d>& eye = std::nullopt) {
  const Vec2d u = random.uniform2();
  return surface.draw(u, random.uniform(), eye);
}

/// The integral of `f` over what lies in the box, as draws have it.
RunningMean integral(const LeafSurface& surface, const std::function<double(Vec3d)>& f,
                     int draws = 100000) {
  Random random(5);
  RunningMean mean;
  for (int i = 0; i < draws; ++i) {
    const auto point = draw(surface, random);
    mean.add(point ? point->multiplicity * f(point->p) / point->density : 0.0);
  }
  return mean;
}

void expect_mean(const RunningMean& measured, double expected) {
  // z = 5: a false alarm in 1.7 million.
  const auto result = test::z_test(measured, expected, 5.0, 1e-9 * expected);
  EXPECT_TRUE(result.accepted) << result.message;
  EXPECT_LT(measured.standard_error(), 0.01 * expected);
}

/// The part of a box that counts.
std::function<double(Vec3d)> inside(const Box3d& box) {
  return [box](Vec3d p) {
    return p.x >= box.min.x && p.y >= box.min.y && p.z >= box.min.z && p.x <= box.max.x &&
                   p.y <= box.max.y && p.z <= box.max.z
               ? 1.0
               : 0.0;
  };
}

TEST(LeafSurface, HasTheAreaThatIsInItsBox) {
  const Box3d unit{{0, 0, 0}, {1, 1, 1}};
  const auto area_in = [](const PlacedSolid& solid, const Box3d& box) {
    return integral(LeafSurface(solid, box, both_sides), inside(box));
  };
  // A plane across the box: along its edges, and through three of its corners.
  expect_mean(area_in({HalfSpace{{0.5, 0, 0.5}, {3, 0, 3}}, {}}, unit), std::sqrt(2.0));
  expect_mean(area_in({HalfSpace{{1, 0, 0}, {1, 1, 1}}, {}}, unit), std::sqrt(3.0) / 2);
  expect_mean(area_in({HalfSpace{{0, 0, 0.3}, {0, 0, 1}}, {}}, unit), 1.0);
  // The box that a plane along an axis is clipped to may end in it.
  expect_mean(area_in({HalfSpace{{0, 0, 0.3}, {0, 0, 1}}, {}}, {{0, 0, 0}, {1, 1, 0.3}}), 1.0);
  // A zone of a sphere (Archimedes), and what a box cuts out of a huge one: nearly a plane.
  expect_mean(area_in({Sphere{}, {}}, {{-1, -1, 0.2}, {1, 1, 0.3}}), 2 * pi * 0.1);
  const double R = 1e4, cap = 2 * pi * R * 0.25;
  expect_mean(area_in({Sphere{{0, 0, R}, R}, {}}, {{-90, -90, 0}, {90, 90, 0.25}}), cap);
  // A paraboloid up to the height 2, also squashed and turned: A = pi / 6 (9^1.5 - 1).
  const double bowl = pi / 6 * 26;
  const Box3d around{{-2, -2, 0}, {2, 2, 2}};
  expect_mean(area_in(paraboloid(), around), bowl);
  const Transform tip = Transform::rotation({1, 0, 0}, 0.5 * pi);
  expect_mean(area_in(paraboloid(tip), tip.box(around)), bowl);
  const Transform grown = Transform::scaling({3, 3, 3});
  expect_mean(area_in(paraboloid(grown), grown.box(around)), 9 * bowl);
  // By area: all of it is drawn, and the box need not be met.
  expect_mean(integral(LeafSurface({Cylinder{{0, 0, 0}, {0, 0, 1}, 1}, {}},
                                   {{-1, -1, 0}, {1, 1, 1}}, both_sides),
                       [](Vec3d) { return 1.0; }),
              4 * pi);
}

/// Thins draws to points that are uniform by area if the densities are right.
template <typename Cell>
test::ChiSquaredResult uniform_by_area(const LeafSurface& surface, const Cell& cell_of,
                                       std::size_t cells, double greatest) {
  Random random(9);
  std::vector<double> observed(cells), expected(cells);
  double total = 0, most = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto point = draw(surface, random);
    if (!point) continue;
    const double kept = point->multiplicity / point->density / greatest;
    most = std::max(most, kept);
    if (random.uniform() >= kept) continue;
    const std::optional<std::size_t> cell = cell_of(point->p);
    if (!cell) continue;
    observed[*cell] += 1, total += 1;
  }
  EXPECT_LE(most, 1.0 + 1e-9);
  EXPECT_GT(total, 20000);
  std::fill(expected.begin(), expected.end(), total / static_cast<double>(cells));
  return test::chi_squared_test(observed, expected, 1e-6);  // the false-alarm rate
}

/// The cell of a 12 x 12 grid over the angle about z and a number in [0, 1).
std::optional<std::size_t> ring_cell(Vec3d p, double along) {
  const double turn = std::atan2(p.y, p.x) / (2 * pi) + 0.5;
  if (!(along >= 0 && along < 1)) return std::nullopt;
  return static_cast<std::size_t>(std::min(turn * 12, 11.5)) * 12 +
         static_cast<std::size_t>(along * 12);
}

TEST(LeafSurface, IsDrawnFromUniformlyWhereItSaysSo) {
  const LeafSurface zone({Sphere{}, {}}, {{-1, -1, -0.1}, {1, 1, 0.3}}, both_sides);
  const auto in_zone = [](Vec3d p) { return ring_cell(p, (p.z + 0.1) / 0.4); };
  auto result = uniform_by_area(zone, in_zone, 144, 2 * 5.6);
  EXPECT_TRUE(result.accepted) << result.message;

  // The area of a paraboloid grows as (1 + 4 z)^1.5.
  const LeafSurface bowl(paraboloid(), {{-1, -1, 0}, {1, 1, 1}}, both_sides);
  const auto in_bowl = [](Vec3d p) {
    return ring_cell(p, (std::pow(1 + 4 * p.z, 1.5) - 1) / (std::pow(5.0, 1.5) - 1));
  };
  result = uniform_by_area(bowl, in_bowl, 144, 2 * 8.0);
  EXPECT_TRUE(result.accepted) << result.message;

  const LeafSurface slope({HalfSpace{{0.5, 0, 0.5}, {1, 0, 1}}, {}}, {{0, 0, 0}, {1, 1, 1}},
                          both_sides);
  const auto on_slope = [](Vec3d p) -> std::optional<std::size_t> {
    return static_cast<std::size_t>(std::min(p.x * 12, 11.5)) * 12 +
           static_cast<std::size_t>(std::min(p.y * 12, 11.5));
  };
  result = uniform_by_area(slope, on_slope, 144, std::sqrt(2.0));
  EXPECT_TRUE(result.accepted) << result.message;
}

TEST(LeafSurface, DrawsWhatCanBeSeen) {
  Random random(4);
  const Box3d box{{-1, -1, 0}, {1, 1, 1}};
  const std::vector<PlacedSolid> solids{paraboloid(), {Sphere{}, {}}, {Cylinder{}, {}}};
  for (const PlacedSolid& solid : solids) {
    for (const SeenSides sides : {SeenSides{true, false}, SeenSides{false, true}, both_sides}) {
      const LeafSurface surface(solid, box, sides);
      for (int i = 0; i < 2000; ++i) {
        const Vec3d eye = 3.0 * random.direction();
        const auto point = draw(surface, random, eye);
        if (!point) continue;
        const bool outside = dot(eye - point->p, point->normal) > 0;
        EXPECT_TRUE(outside ? sides.outside : sides.inside);
        EXPECT_NEAR(point->density, surface.density(point->patch, point->p), 1e-9 * point->density);
      }
    }
  }
}

// Numbers at the ends of their range, boxes without thickness.
TEST(LeafSurface, SurvivesHostileNumbers) {
  const double below_one = 1 - 0x1p-53;
  const std::vector<PlacedSolid> solids{
      paraboloid(), {HalfSpace{{0, 0, 1}, {0, 0, 1}}, {}}, {HalfSpace{{0, 0, 1}, {1, 2, 3}}, {}}};
  for (const PlacedSolid& solid : solids) {
    for (const double height : {0.0, 1e-12, 1.0}) {
      const LeafSurface surface(solid, {{0, 0, 1 - height}, {1, 1, 1}}, both_sides);
      EXPECT_TRUE(surface.measure() > 0 && std::isfinite(surface.measure()));
      for (const double a : {0.0, 0.3, below_one}) {
        for (const double b : {0.0, 0.7, below_one}) {
          const auto point = surface.draw({a, b}, b, std::nullopt);
          if (!point) continue;
          EXPECT_TRUE(point->density > 0 && std::isfinite(point->density));
          EXPECT_GE(point->multiplicity, 1.0);
        }
      }
    }
  }
}

constexpr SurfaceTag glowing = 7;

Box snapped_box(Random& random) {
  Vec3d a, b;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto low = static_cast<double>(random.index(4));
    a[i] = low, b[i] = low + 1 + static_cast<double>(random.index(3));
  }
  return {a, b};
}

PlacedSolid random_leaf(Random& random) {
  const Vec3d center{2 + 2 * random.uniform(), 2 + 2 * random.uniform(), 2 + 2 * random.uniform()};
  switch (random.index(6)) {
    case 0: {
      Mat3 leaning;
      for (Vec3d& row : leaning.row) row = row + 0.7 * random.direction();
      const auto map = Transform::affine(leaning, center);
      return {Sphere{}, map ? *map : Transform()};
    }
    case 1:
      return {HalfSpace{center, random.direction()}, {}};
    case 2:
      return {Cylinder{center, center + 2.0 * random.direction(), 0.7}, {}};
    default:
      return {snapped_box(random), {}};
  }
}

/// A random tree of leaves, many of which share faces; about half of them glow.
Expression::Term random_term(Expression& expression, int depth, Random& random) {
  Expression::Term term;
  if (depth == 0) {
    const SurfaceTag tag = random.index(2) == 0 ? glowing : inherited_surface;
    term = expression.add(random_leaf(random), tag);
  } else {
    std::vector<Expression::Term> operands;
    for (int i = 0; i < 2; ++i) operands.push_back(random_term(expression, depth - 1, random));
    const auto operation = random.index(2) == 0 ? Operation::unite : Operation::intersect;
    term = expression.add(operation, operands);
  }
  return random.index(4) == 0 ? ~term : term;
}

struct Lone {
  explicit Lone(const Expression& whole, Expression::Term root) : part(part_of(whole, root)) {
    SolidScene::Parts parts;
    parts.expression = part.expression;
    Region region;
    region.root = part.root;
    region.medium = 1;
    parts.regions.push_back(region);
    scene = SolidScene(std::move(parts));
  }

  std::optional<CompoundSurface> surface() const {
    const Compound& compound = scene.world();
    std::vector<Box3d> bounds;
    for (const auto& leaf : compound.leaves()) bounds.push_back(geometry::bounds(leaf.solid));
    const auto boxes = clipped_bounds(compound.tree(), bounds).leaves;
    std::vector<CompoundSurface::Piece> pieces;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (compound.leaf(i).tag != glowing || boxes[i].empty()) continue;
      pieces.push_back(
          {part.leaf_numbers[i], LeafSurface(compound.leaf(i).solid, boxes[i], both_sides)});
    }
    if (pieces.empty()) return std::nullopt;
    return CompoundSurface(std::move(pieces));
  }

  ExpressionPart part;
  SolidScene scene;
};

/// By Crofton's formula: A = 2 pi R^2 times the mean number of crossings with lines that meet a
/// ball of radius R, here all that show `glowing`.
RunningMean crofton_area(const SolidScene& scene, Vec3d center, double radius, int lines) {
  Random random(77);
  RunningMean mean;
  for (int i = 0; i < lines; ++i) {
    const Vec3d d = random.direction(), side = normalize(cross(d, random.direction()));
    const double r = radius * std::sqrt(random.uniform());
    const Ray ray{center + side * r - d * (2 * radius), d};
    Sweep sweep(scene, ray);
    double crossings = 0;
    for (Transition found; sweep.next(found);) crossings += found.tag == glowing ? 1 : 0;
    mean.add(2 * pi * radius * radius * crossings);
  }
  return mean;
}

// Of random combinations full of coincident faces, some of whose leaves glow; the lines know
// nothing of leaves.
TEST(WornArea, AgreesWithLines) {
  Random random(31);
  ThreadPool pool(1);
  int measured = 0;
  for (int i = 0; i < 60; ++i) {
    Expression expression;
    random_term(expression, 2, random);  // something else that the part leaves out
    const std::vector<Expression::Term> both{random_term(expression, 3, random),
                                             expression.add({Box{{0, 0, 0}, {6, 6, 6}}, {}})};
    const Lone lone(expression, expression.add(Operation::intersect, both));
    const auto surface = lone.surface();
    if (!surface) continue;
    const AreaEstimate area = worn_area({lone.scene, *surface, lone.part.leaf_numbers},
                                        Mat3::identity(), {0.02, 1 << 14}, pool);
    const RunningMean lines = crofton_area(lone.scene, {3, 3, 3}, 5.2, 4000);
    // 5.5 sigma of both; those of the estimate come from 16 numbers: t(15) is beyond that once in
    // 2e4 where it alone counts, which it does not.
    const double of_few = std::sqrt(area.area * 2 * pi * 5.2 * 5.2 / 4000);  // Poisson's
    const double sigma = std::hypot(area.standard_error, std::max(of_few, lines.standard_error()));
    EXPECT_NEAR(area.area, lines.mean(), 5.5 * sigma + 1e-9) << i;
    measured += area.area > 0 ? 1 : 0;
  }
  EXPECT_GT(measured, 25);
}

TEST(WornArea, IsExactToWhatItSays) {
  ThreadPool pool(2);
  Expression expression;
  const std::vector<Expression::Term> terms{
      expression.add({Box{{-1, -1, -1}, {1, 1, 1}}, {}}, glowing),
      ~expression.add({Cylinder{{0, 0, -2}, {0, 0, 2}, 0.5}, {}}, glowing)};
  const Lone lone(expression, expression.add(Operation::intersect, terms));
  const auto surface = lone.surface();
  const WornSurface worn{lone.scene, *surface, lone.part.leaf_numbers};
  const double exact = 24 - 2 * pi * 0.25 + 2 * pi * 0.5 * 2;
  const AreaEstimate area = worn_area(worn, Mat3::identity(), {0.001 / 3, 1 << 20}, pool);
  EXPECT_NEAR(area.area, exact, 0.001 * exact);
  EXPECT_LT(area.standard_error, 0.001 / 3 * exact);
  // Stretched along z: the hole with the sides.
  const Mat3 stretch = Transform::scaling({1, 1, 3}).linear();
  const double tall = 8 - 2 * pi * 0.25 + 3 * (16 + 2 * pi * 0.5 * 2);
  EXPECT_NEAR(worn_area(worn, stretch, {0.001 / 3, 1 << 20}, pool).area, tall, 0.001 * tall);
}

TEST(ExpressionPart, KeepsWhatIsSharedAndTheOrder) {
  Expression whole;
  const auto a = whole.add({Sphere{}, {}}, 1), b = whole.add({Sphere{{1, 0, 0}, 1}, {}}, 2);
  const auto c = whole.add({Sphere{{2, 0, 0}, 1}, {}}, 3);
  const std::vector<Expression::Term> ca{c, ~a};
  const auto shared = whole.add(Operation::intersect, ca);
  whole.add(Operation::unite, std::vector<Expression::Term>{a, b});
  const auto root = whole.add(Operation::unite, std::vector<Expression::Term>{shared, ~shared, c});
  const ExpressionPart part = part_of(whole, ~root);
  EXPECT_EQ(part.leaf_numbers, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(part.expression.leaves()[1].tag, 3u);
  EXPECT_EQ(part.expression.nodes().size(), 2u);
  EXPECT_TRUE(part.root.is_complement());
  const ExpressionPart leaf = part_of(whole, ~b);
  EXPECT_TRUE(leaf.root.is_leaf() && leaf.root.is_complement());
  EXPECT_EQ(leaf.leaf_numbers, std::vector<std::uint32_t>{1});
}

}  // namespace
}  // namespace lapidary::geometry
