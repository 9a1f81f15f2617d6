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
  EXPECT_THAT(message_of(replaced(lamp, " 3 2 1 ", " 3 2 2 ")),
              HasSubstr("photometry type B, which is not read"));
  EXPECT_THAT(message_of(replaced(lamp, "0 45 90", "0 45 45")),
              HasSubstr("lamp.ies:7: a vertical angle of 45 must be greater"));
  EXPECT_THAT(message_of(replaced(lamp, "0 45 90", "0 45 80")), HasSubstr("not from 0 to 80"));
  EXPECT_THAT(message_of(replaced(lamp, "0, 90", "0, 95")), HasSubstr("horizontal angles of type"));
  EXPECT_THAT(message_of(replaced(lamp, "1 1000 2 3", "1 1000 0 3")),
              HasSubstr("the profile gives no light"));
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
