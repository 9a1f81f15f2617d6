#include <gtest/gtest.h>

#include "event_checks.h"
#include "geometry/solid.h"
#include "hostile_lines.h"

namespace lapidary::geometry {
namespace {

using exact::Tally;
using lapidary::test::Random;

Line line_at(const Solid& solid, const hostile::Setting& setting, Random& random) {
  if (random.index(4) != 0) return hostile::line(setting, random);
  const Vec2d u = random.uniform2();
  const BoundaryPoint b = sample_boundary(solid, u, random.uniform());
  return hostile::grazing_line(b.p, b.normal, setting.scale, random);
}

template <typename MakeSolid>
Tally compare(MakeSolid make, std::uint64_t seed, int lines) {
  Random random(seed);
  Tally tally;
  EventBuffer events;
  for (int i = 0; i < lines; ++i) {
    const hostile::Setting setting = hostile::setting(random);
    const Solid solid = make(setting, random);
    const Line line = line_at(solid, setting, random);
    intervals(solid, line, events);
    const exact::Case c{solid, line, exact::exact_line(line), exact::distance_scale(solid, line),
                        64 * unit_roundoff};
    const auto result = exact::check(c, events, tally);
    EXPECT_TRUE(result) << "line " << i;
    if (!result) break;
  }
  EXPECT_GT(tally.hits, lines / 8);
  return tally;
}

constexpr int lines_per_kind = 200000;

TEST(SolidIntervals, OfSpheresStayWithinTheirBounds) {
  exact::expect_tight(compare(hostile::sphere, 1, lines_per_kind), 1e-14);
}
TEST(SolidIntervals, OfBoxesStayWithinTheirBounds) {
  exact::expect_tight(compare(hostile::box, 2, lines_per_kind), 1e-14);
}
TEST(SolidIntervals, OfHalfSpacesStayWithinTheirBounds) {
  exact::expect_tight(compare(hostile::half_space, 3, lines_per_kind), 1e-14);
}
TEST(SolidIntervals, OfCylindersStayWithinTheirBounds) {
  exact::expect_tight(compare(hostile::cylinder, 4, lines_per_kind), 1e-14);
}

}  // namespace
}  // namespace lapidary::geometry
