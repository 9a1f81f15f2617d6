// A closed mesh minus a cylinder: what the cut lays open is as tight as the mesh.

#include <gtest/gtest.h>

#include "geometry/sweep.h"
#include "math/frame.h"
#include "meshes.h"
#include "triangle_soup.h"

namespace lapidary::geometry {
namespace {

using exact::Soup;
using lapidary::test::Random;
using Real = Soup::Real;
using Point = Soup::Point;

/// With a hole from `top`, outside, to `bottom`, inside.
struct Cut {
  TriangleMesh mesh = meshes::star(9, 14, 16);
  Soup soup{mesh};
  MeshBody body = make_mesh_body(std::make_shared<const TriangleMesh>(mesh));
  Cylinder hole{{0.05, -0.02, 0.03}, {0.9, 1.1, 1.3}, 0.125};
  SolidScene scene = scene_of(body, hole);

  static SolidScene scene_of(const MeshBody& body, const Cylinder& hole) {
    Expression expression;
    const Expression::Term operands[]{expression.add(PlacedSolid(body, {})),
                                      ~expression.add(PlacedSolid(hole, {}))};
    Region region;
    region.root = expression.add(Operation::intersect, operands);
    region.medium = 1;
    return SolidScene({std::move(expression), {}, {}, {region}});
  }

  /// How far inside of the hole, by the formula of a cylinder.
  Real depth_in_hole(Point p) const {
    const Point from(hole.from), axis = Point(hole.to) - from;
    const Real height = length(axis), along = dot(p - from, axis) / height;
    const Real across = length(cross(p - from, axis)) / height;
    return std::min(std::min(along, height - along), static_cast<Real>(hole.radius) - across);
  }
  bool inside(Point p) const { return depth_in_hole(p) <= 0 && soup.inside(p); }
  Real distance(Point p) const { return std::min(std::abs(depth_in_hole(p)), soup.distance(p)); }

  /// On the rim of the hole: where the wall leaves the mesh, or meets the end within it.
  Vec3d rim(Random& random) const {
    const Frame frame = Frame::from_normal(normalize(hole.to - hole.from));
    const double angle = random.uniform(0, 2 * pi);
    const Vec3d out = frame.tangent * std::cos(angle) + frame.bitangent * std::sin(angle);
    const Line wall{hole.from + out * hole.radius, hole.to - hole.from};
    if (random.index(2) == 0) return wall.origin;
    EventBuffer events;
    intervals(body, wall, events);
    return wall.at(events[events.size() - 1].t);
  }
  /// On the end of the hole, the cap that the cut makes.
  Vec3d cap(Random& random) const {
    const Vec3d p = rim(random), axis = normalize(hole.to - hole.from);
    const Vec3d out = p - hole.from - axis * dot(p - hole.from, axis);
    return hole.from + out * random.uniform();
  }
};

/// Points are slow.
enum class Against : std::uint8_t { parity, points };

/// Past all transitions of a ray through everything: they alternate, the way between two of them is
/// what points say, and at its end nothing is left open.
void check_ray(const Cut& cut, const Ray& ray, Against against, int& pieces) {
  Sweep sweep(cut.scene, ray);
  Transition found;
  std::uint32_t region = SolidScene::no_region;
  double last = 0;
  while (sweep.next(found)) {
    ASSERT_EQ(found.before, region);
    ASSERT_NE(found.after, region);
    const Point p =
        Point(ray.origin) + Point(ray.direction) * static_cast<Real>((last + found.t) / 2);
    if (against == Against::points && cut.distance(p) > 1e-12L) {
      ASSERT_EQ(cut.inside(p), region == 0) << "at " << (last + found.t) / 2;
      ++pieces;
    }
    region = found.after, last = found.t;
  }
  ASSERT_EQ(region, SolidScene::no_region) << "an odd number of transitions";
}

TEST(MeshCut, IsTightAlongItsRimAndAtItsCap) {
  const Cut cut;
  Random random(71);
  int pieces = 0;
  for (int i = 0; i < 10000; ++i) {
    Vec3d target = i % 3 == 2 ? cut.cap(random) : cut.rim(random);
    if (random.index(2) == 0) target += random.direction() * random.magnitude(-17, -2);
    const Vec3d from = random.direction() * random.uniform(3, 5);
    Ray ray;
    ray.origin = from, ray.direction = (target - from) * random.magnitude(-3, 3);
    ASSERT_NO_FATAL_FAILURE(
        check_ray(cut, ray, i % 10 == 0 ? Against::points : Against::parity, pieces))
        << "ray " << i;
  }
  EXPECT_GT(pieces, 2000);
}

}  // namespace
}  // namespace lapidary::geometry
