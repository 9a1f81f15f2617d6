#pragma once

#include <random>
#include <vector>

#include "geometry/world.h"

/// Models of constructive solid geometry that grow with a number. The same as in other renderers'
/// scenes for comparison, so y points up.
namespace lapidary::bench {

using geometry::Box;
using geometry::Cylinder;
using geometry::Expression;
using geometry::Operation;
using geometry::PlacedSolid;
using geometry::Solid;
using Term = Expression::Term;

inline Term leaf(Expression& expression, const Solid& solid) {
  return expression.add(PlacedSolid(solid, {}));
}

/// A plate of 16 x 10 with `columns` x `rows` round holes.
inline Term perforated_plate(Expression& expression, int columns, int rows) {
  const double width = 16, depth = 10;
  const double dx = width / columns, dz = depth / rows, radius = 0.35 * std::min(dx, dz);
  std::vector<Term> operands{leaf(expression, Box{{-8, 1, -5}, {8, 1.5, 5}})};
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double x = -width / 2 + (i + 0.5) * dx, z = -depth / 2 + (j + 0.5) * dz;
      operands.push_back(~leaf(expression, Cylinder{{x, 1, z}, {x, 1.5, z}, radius}));
    }
  }
  return expression.add(Operation::intersect, operands);
}

/// A Menger sponge as a cube minus square bars: 3 (9^level - 1) / 8 of them.
inline Term menger_sponge(Expression& expression, int level) {
  std::vector<Term> operands{leaf(expression, Box{{-1, -1, -1}, {1, 1, 1}})};
  for (int k = 0, m = 1; k < level; ++k, m *= 3) {
    const double cell = 2.0 / m, half = cell / 6;
    for (int i = 0; i < m * m; ++i) {
      const double a = -1 + (i % m + 0.5) * cell, b = -1 + (i / m + 0.5) * cell;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Box bar{{-1.001, -1.001, -1.001}, {1.001, 1.001, 1.001}};
        const std::size_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
        bar.min[u] = a - half, bar.max[u] = a + half;
        bar.min[v] = b - half, bar.max[v] = b + half;
        operands.push_back(~leaf(expression, bar));
      }
    }
  }
  return expression.add(Operation::intersect, operands);
}

/// The 57 facets of a round brilliant, about as they are cut.
inline std::vector<geometry::HalfSpace> brilliant_facets() {
  std::vector<geometry::HalfSpace> facets{{{0, 0.45, 0}, {0, 1, 0}}};
  const auto ring = [&](int count, double first, double height, double tilt, double distance) {
    for (int i = 0; i < count; ++i) {
      const double turn = 2 * pi * (i + first) / count;
      const Vec3d n{std::cos(turn) * std::cos(tilt), std::sin(tilt),
                    std::sin(turn) * std::cos(tilt)};
      facets.push_back({Vec3d{0, height, 0} + n * distance, n});
    }
  };
  ring(8, 0.5, 0.0, 1.185, 0.433);    // stars
  ring(8, 0.0, 0.0, 0.969, 0.602);    // kites
  ring(16, 0.5, 0.0, 0.852, 0.668);   // upper girdle
  ring(16, 0.5, 0.0, -0.846, 0.665);  // lower girdle
  ring(8, 0.0, 0.0, -0.859, 0.652);   // pavilion
  return facets;
}

/// The same gem in two ways of writing.
inline Term brilliant_of_half_spaces(Expression& expression) {
  std::vector<Term> operands;
  for (const geometry::HalfSpace& facet : brilliant_facets()) {
    operands.push_back(leaf(expression, facet));
  }
  return expression.add(Operation::intersect, operands);
}
inline Term brilliant_polyhedron(Expression& expression) {
  return leaf(expression, *geometry::intersection(brilliant_facets()));
}

/// A solid with a round hole.
inline Term drilled(Expression& expression, const Solid& solid, const Cylinder& hole) {
  const Term operands[]{leaf(expression, solid), ~leaf(expression, hole)};
  return expression.add(Operation::intersect, operands);
}

/// A binary tree of differences, unions and intersections in turn, 2^depth random leaves.
class AlternatingTree {
 public:
  AlternatingTree(Expression& expression, int depth) : expression_(expression), depth_(depth) {}
  Term build() { return build(depth_); }

 private:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Term random_leaf() {
    const Vec3d c{uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
    const double r = uniform(0.35, 0.8);
    switch (random_() % 3) {
      case 0:
        return leaf(expression_, geometry::Sphere{c, r});
      case 1:
        return leaf(expression_, Box{c - Vec3d{r, r, r}, c + Vec3d{r, r, r}});
      default:
        return leaf(expression_, Cylinder{c - Vec3d{0, r, 0}, c + Vec3d{0, r, 0}, 0.7 * r});
    }
  }
  Term combine(Operation operation, Term a, Term b) {
    const Term operands[]{a, b};
    return expression_.add(operation, operands);
  }
  Term build(int d) {
    if (d == 0) return random_leaf();
    const Term a = build(d - 1), b = build(d - 1);
    switch ((depth_ - d) % 4) {
      case 0:
        return combine(Operation::intersect, a, ~b);
      case 2:
        return combine(Operation::intersect, leaf(expression_, geometry::Sphere{{}, 1.9}),
                       combine(Operation::unite, a, b));
      default:
        return combine(Operation::unite, a, b);
    }
  }

  Expression& expression_;
  int depth_;
  std::mt19937_64 random_{7};
};

}  // namespace lapidary::bench
