#include "light/ies_file.h"

#include <gmock/gmock.h>

#include "base/error.h"
#include "math/constants.h"
#include "support/random.h"

namespace lapidary::light {
namespace {

using lapidary::test::Random;
using testing::HasSubstr;

const std::string lamp =
    "IESNA:LM-63-2002\n"
    "[TEST] a lamp of our own\n"
    "[MANUFAC] nobody\n"
    "TILT=NONE\n"
    "1 1000 2 3 2 1 2 0 0 0\n"
    "0.5 1 60\n"
    "0 45 90\n"
    "0, 90\n"
    "10 20 30\n"
    "10 40 50\n";

std::string replaced(std::string text, const std::string& a, const std::string& b) {
  text.replace(text.find(a), a.size(), b);
  return text;
}

std::string message_of(const std::string& text) {
  try {
    parse_ies(text, "lamp.ies");
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(IesFile, IsReadWithItsFactors) {
  const PhotometricWeb web = parse_ies(lamp, "lamp.ies");
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(web.intensity({0, 0, 1}), 10, 1e-6);  // twice 10, at half of the ballast
  EXPECT_NEAR(web.intensity({half, 0, half}), 20, 1e-5);
  EXPECT_NEAR(web.intensity({0, -1, 0}), 50, 1e-5);
  EXPECT_NEAR(web.intensity({0, 1, 0}), 50, 1e-5);
  EXPECT_EQ(web.intensity({0, 0, -1}), 0.0);
}

TEST(IesFile, OfEachRevisionIsRead) {
  for (const char* first :
       {"IESNA91", "IESNA:LM-63-1995", "IES:LM-63-2019", "A lamp of 1986", "IESNA:LM-63-2002\r"}) {
    const PhotometricWeb web = parse_ies(replaced(lamp, "IESNA:LM-63-2002", first), "lamp.ies");
    EXPECT_NEAR(web.intensity({0, 0, 1}), 10, 1e-6) << first;
  }
  // Only old files have a ballast-lamp factor.
  const std::string factor = replaced(lamp, "0.5 1 60", "0.5 0.1 60");
  EXPECT_NEAR(parse_ies(factor, "").intensity({0, 0, 1}), 10, 1e-6);
  EXPECT_NEAR(parse_ies(replaced(factor, "IESNA:LM-63-2002", "IESNA91"), "").intensity({0, 0, 1}),
              1, 1e-6);
}

TEST(IesFile, PassesOverWhatItSaysOfTilt) {
  const std::string tilted =
      replaced(lamp, "TILT=NONE\n", "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9 0.8\n");
  EXPECT_NEAR(parse_ies(tilted, "").intensity({0, 0, 1}), 10, 1e-6);
  EXPECT_NEAR(parse_ies(replaced(lamp, "NONE", "other.tlt"), "").intensity({0, 0, 1}), 10, 1e-6);
  EXPECT_THAT(message_of(replaced(tilted, "\n3\n", "\n1e12\n")),
              HasSubstr("lamp.ies:6: the number of tilt angles must be a whole number"));
}

TEST(IesFile, ThatIsWrongSaysWhatAndWhere) {
  EXPECT_THAT(message_of(""), HasSubstr("lamp.ies:1: the file has no line TILT="));
  EXPECT_THAT(message_of("a\nb\n"), HasSubstr("lamp.ies:2: the file has no line TILT="));
  EXPECT_THAT(message_of(lamp.substr(0, lamp.size() - 4)),
              HasSubstr("lamp.ies:10: the file ends where a value in candela should be"));
  EXPECT_THAT(message_of(replaced(lamp, "10 40", "10 -40")),
              HasSubstr("lamp.ies:10: a value in candela must not be negative, but is -40"));
  EXPECT_THAT(message_of(replaced(lamp, "20 30", "nan 30")), HasSubstr("lamp.ies:9: a value"));
  EXPECT_THAT(message_of(replaced(lamp, "20 30", "inf 30")), HasSubstr("not 'inf'"));
  EXPECT_THAT(message_of(replaced(lamp, "20 30", "2x0 30")), HasSubstr("not '2x0'"));
  EXPECT_THAT(message_of(replaced(lamp, " 3 2 1 ", " 3000000000 2 1 ")),
              HasSubstr("lamp.ies:5: the number of vertical angles must be a whole number from 2"));
  EXPECT_THAT(message_of(replaced(lamp, " 3 2 1 ", " 3 -2 1 ")), HasSubstr("horizontal angles"));
  EXPECT_THAT(message_of(replaced(lamp, " 3 2 1 ", " 3 2 4 ")),
              HasSubstr("the type of photometry must be a whole number from 1 to 3, not 4"));
  EXPECT_THAT(message_of(replaced(lamp, "0 45 90", "0 45 45")),
              HasSubstr("lamp.ies:7: a vertical angle of 45 must be greater"));
  EXPECT_THAT(message_of(replaced(lamp, "0 45 90", "0 45 80")), HasSubstr("not from 0 to 80"));
  EXPECT_THAT(message_of(replaced(lamp, "0, 90", "0, 95")), HasSubstr("horizontal angles of type"));
  EXPECT_THAT(message_of(replaced(lamp, "1 1000 2 3", "1 1000 0 3")),
              HasSubstr("the profile gives no light"));
}

// A floodlight: 5 candela straight on, more to the right and above, each by its own angle.
std::string beam(const std::string& type) {
  return "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 3 " + type +
         " 2 0 0 0\n1 1 60\n-30 0 60\n-90 0 45\n"
         "1 1 1\n2 5 20\n7 8 9\n";
}

Vec3d turned(double first, double second) {
  return {radians(first), radians(second), 0};
}

// Of type B a point of the lamp's aim is reached by turning up about the level axis by the vertical
// angle, and then right, in the plane there; of type A the other way round.
TEST(IesFile, OfBeamsIsReadByTheirPolarAxis) {
  const PhotometricWeb b = parse_ies(beam("2"), "b.ies"), a = parse_ies(beam("3"), "a.ies");
  const auto direction_b = [](double v, double h) {
    const Vec3d t = turned(v, h);
    return Vec3d(std::cos(t.y) * std::sin(t.x), std::sin(t.y), std::cos(t.y) * std::cos(t.x));
  };
  const auto direction_a = [](double v, double h) {
    const Vec3d t = turned(v, h);
    return Vec3d(std::sin(t.x), std::cos(t.x) * std::sin(t.y), std::cos(t.x) * std::cos(t.y));
  };
  const double vertical[] = {-30, 0, 60}, horizontal[] = {-90, 0, 45};
  const double candela[] = {1, 1, 1, 2, 5, 20, 7, 8, 9};
  for (int h = 0; h < 3; ++h) {
    for (int v = 0; v < 3; ++v) {
      // At a pole all longitudes are one.
      if (h > 0) {
        EXPECT_NEAR(b.intensity(direction_b(vertical[v], horizontal[h])), candela[3 * h + v], 1e-4);
      }
      EXPECT_NEAR(a.intensity(direction_a(vertical[v], horizontal[h])), candela[3 * h + v], 1e-4);
    }
  }
  // Half way in one angle, in both types; far apart where both are not zero.
  EXPECT_NEAR(b.intensity(direction_b(30, 0)), 12.5, 1e-4);
  EXPECT_NEAR(a.intensity(direction_a(0, 22.5)), 6.5, 1e-4);
  // Nothing beyond the table, behind the lamp least of all.
  for (const PhotometricWeb& web : {a, b}) {
    EXPECT_EQ(web.intensity({0, 0, -1}), 0.0);
    EXPECT_EQ(web.intensity(direction_a(-31, 0)), 0.0);
    EXPECT_EQ(web.intensity(direction_a(61, 0)), 0.0);
  }
  EXPECT_EQ(a.intensity(direction_a(0, 46)), 0.0);
  EXPECT_EQ(b.intensity(direction_b(0, 46)), 0.0);
}

TEST(IesFile, OfHalfABeamIsMirrored) {
  const std::string half =
      "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 2 2 2 0 0 0\n1 1 60\n0 90\n0 90\n10 4\n2 2\n";
  for (const char* type : {" 2 2 2 2 ", " 2 2 3 2 "}) {
    const PhotometricWeb web = parse_ies(replaced(half, " 2 2 2 2 ", type), "");
    Random random(7);
    for (int i = 0; i < 100; ++i) {
      const Vec3d v = abs(random.direction());
      const double seen = web.intensity(v);
      EXPECT_GT(seen, 0.0);
      EXPECT_NEAR(web.intensity({-v.x, v.y, v.z}), seen, 1e-5);
      EXPECT_NEAR(web.intensity({v.x, -v.y, v.z}), seen, 1e-5);
      EXPECT_EQ(web.intensity({v.x, v.y, -v.z}), 0.0);
    }
    EXPECT_NEAR(web.least_cosine(), 0.0, 1e-12);
  }
  EXPECT_THAT(message_of(replaced(half, "0 90\n0 90", "10 90\n0 90")),
              HasSubstr("vertical angles of types A and B go from 0"));
  EXPECT_THAT(message_of(replaced(half, "0 90\n0 90", "0 90\n0 120")),
              HasSubstr("not from 0 to 120"));
}

TEST(IesFile, OfAnyBytesIsReadOrRefused) {
  Random random(3);
  for (int k = 0; k < 20000; ++k) {
    std::string text =
        lamp.substr(0, random.index(2) == 0 ? lamp.size() : random.index(lamp.size()));
    for (std::uint64_t n = random.index(4); n > 0 && !text.empty(); --n) {
      text[random.index(text.size())] = static_cast<char>(random.index(256));
    }
    try {
      const double flux = parse_ies(text, "lamp.ies").flux();
      EXPECT_TRUE(flux > 0.0 && std::isfinite(flux));
    } catch (const Error& error) {
      EXPECT_GE(error.where().line, 1);
    }
  }
}

}  // namespace
}  // namespace lapidary::light
