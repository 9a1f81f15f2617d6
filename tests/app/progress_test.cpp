#include "app/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lapidary::app {
namespace {

using testing::HasSubstr;
using testing::Not;

const ProgressState half_way = {.fraction = 0.5,
                                .samples = 32,
                                .seconds = 10,
                                .samples_per_second = 1.25e6,
                                .seconds_left = 10,
                                .noise = 0.0314,
                                .photons = 12'345'678,
                                .frame = 17};

TEST(Progress, DurationsReadWell) {
  EXPECT_EQ(format_duration(0), "0.0 s");
  EXPECT_EQ(format_duration(9.94), "9.9 s");
  EXPECT_EQ(format_duration(59.4), "59 s");
  EXPECT_EQ(format_duration(59.6), "1 min 0 s");
  EXPECT_EQ(format_duration(200), "3 min 20 s");
  EXPECT_EQ(format_duration(7500), "2 h 5 min");
  EXPECT_NO_FATAL_FAILURE(format_duration(1e300));
}

TEST(Progress, BarFitsAnyWidth) {
  for (int width = 0; width < 200; ++width) {
    EXPECT_LE(bar_line(half_way, width).size(), static_cast<std::size_t>(width));
  }
}

TEST(Progress, BarShowsEverythingWhereThereIsRoom) {
  const std::string line = bar_line(half_way, 150);
  EXPECT_THAT(line, HasSubstr("####...."));
  for (const char* fact : {"frame 17", "50 %", "10 s left", "noise 0.0314", "32 samples per pixel",
                           "1.25 M samples/s", "12.3 M photons"}) {
    EXPECT_THAT(line, HasSubstr(fact));
  }
}

TEST(Progress, WhatIsUnknownIsLeftOut) {
  ProgressState state = half_way;
  state.noise.reset();
  state.seconds_left.reset();
  state.photons = 0;
  state.frame.reset();
  for (const char* fact : {"noise", "left", "photons", "frame"}) {
    EXPECT_THAT(plain_line(state), Not(HasSubstr(fact)));
  }
  const auto object = nlohmann::json::parse(json_line(state));
  EXPECT_FALSE(object.contains("noise"));
  EXPECT_FALSE(object.contains("seconds_left"));
  EXPECT_FALSE(object.contains("photons"));
  EXPECT_FALSE(object.contains("frame"));
  EXPECT_EQ(object.at("fraction"), 0.5);
  EXPECT_EQ(object.at("samples_per_pixel"), 32);
}

}  // namespace
}  // namespace lapidary::app
