#include "import/numbers.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/random.h"

namespace lapidary::import {
namespace {

struct Parsed {
  NumberStatus status = NumberStatus::ok;
  double value = 0;
  std::size_t length = 0;
};

Parsed parse(const std::string& text) {
  Parsed result;
  const char* p = text.c_str();
  result.status = parse_number(p, result.value);
  result.length = static_cast<std::size_t>(p - text.c_str());
  return result;
}

// The C library rounds correctly: the same bits are expected.
void expect_like_strtod(const std::string& text) {
  const Parsed ours = parse(text);
  const double theirs = std::strtod(text.c_str(), nullptr);
  ASSERT_EQ(ours.status, NumberStatus::ok) << text;
  EXPECT_EQ(ours.length, text.size()) << text;
  EXPECT_EQ(std::memcmp(&ours.value, &theirs, sizeof(double)), 0)
      << text << ": " << ours.value << " is not " << theirs;
}

TEST(Numbers, ReadsAllWaysToWriteThem) {
  for (const char* text : {"0",
                           "-0",
                           "+0",
                           "1",
                           "-1",
                           "+1",
                           "007",
                           "1.",
                           ".5",
                           "-.5e-3",
                           "+7.25E+02",
                           "1e5",
                           "1E05",
                           ".8e-001",
                           "-.7e+02",
                           "22824.3964999999989231583",
                           "-0.1035502999999999979",
                           "9007199254740993",
                           "9007199254740992.5",
                           "123456789012345678901234567890",
                           "1e22",
                           "1e23",
                           "1e-22",
                           "1e-23",
                           "5e-324",
                           "2.2250738585072011e-308",
                           "1.7976931348623157e308",
                           "0.000000000000000000000000000001",
                           "1000000000000000000000000000000e-30"}) {
    expect_like_strtod(text);
  }
}

TEST(Numbers, RoundsCorrectlyWhateverTheLength) {
  test::Random random(42);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-1, 1) * random.magnitude(-12, 12);
    const int digits = static_cast<int>(random.index(22));
    expect_like_strtod(fmt::format("{:.{}f}", x, digits));
    expect_like_strtod(fmt::format("{:.{}e}", x, digits));
    expect_like_strtod(fmt::format("{}", x));
  }
}

TEST(Numbers, StopsWhereTheNumberStops) {
  EXPECT_EQ(parse("1.5/2").length, 3);
  EXPECT_EQ(parse("3 4").length, 1);
  EXPECT_EQ(parse("1.2.3").length, 3);
  EXPECT_EQ(parse("0x10").length, 1);
}

TEST(Numbers, RefusesWhatIsNone) {
  for (const char* text : {"", " 1", "-", "+", ".", "-.", "e5", "1e", "1e+", "1.5e-", "nan", "inf",
                           "-inf", "NaN", "--1", "+-1", "abc", "/1"}) {
    EXPECT_EQ(parse(text).status, NumberStatus::malformed) << text;
    EXPECT_EQ(parse(text).length, 0) << text;
  }
}

TEST(Numbers, TellsTooLargeFromTooSmall) {
  for (const char* text : {"1e309", "-1e309", "1e999999999999", "123e400"}) {
    EXPECT_EQ(parse(text).status, NumberStatus::too_large) << text;
  }
  EXPECT_EQ(parse(std::string(400, '9')).status, NumberStatus::too_large);
  for (const std::string& text : {std::string("1e-400"), std::string("-1e-999999999999"),
                                  "0." + std::string(500, '0') + "1", std::string("0e999999")}) {
    EXPECT_EQ(parse(text).status, NumberStatus::ok) << text;
    EXPECT_EQ(parse(text).value, 0.0) << text;
  }
  EXPECT_TRUE(std::signbit(parse("-1e-400").value));
}

TEST(Numbers, ReadsIntegers) {
  const auto integer = [](const char* text) {
    std::int64_t value = 77;
    return parse_integer(text, value) ? value : 77;
  };
  EXPECT_EQ(integer("12"), 12);
  EXPECT_EQ(integer("-3/4"), -3);
  EXPECT_EQ(integer("+5"), 5);
  EXPECT_EQ(integer("0"), 0);
  EXPECT_EQ(integer("99999999999999999999999"), 1'000'000'000'000'000'000);
  for (const char* text : {"", "-", "x", "/1", " 1"}) EXPECT_EQ(integer(text), 77) << text;
}

}  // namespace
}  // namespace lapidary::import
