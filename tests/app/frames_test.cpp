#include "app/frames.h"

#include <gtest/gtest.h>

namespace lapidary::app {
namespace {

TEST(Frames, NumbersFillTheirPlace) {
  EXPECT_EQ(with_frame_number("a_####.png", 7), "a_0007.png");
  EXPECT_EQ(with_frame_number("a_#.png", 123), "a_123.png");
  EXPECT_EQ(with_frame_number("##/a_###", 5), "05/a_005");
  EXPECT_EQ(with_frame_number("###", 0), "000");
  EXPECT_EQ(with_frame_number("a.png", 7), "a.png");
  EXPECT_EQ(with_frame_number("", 7), "");
}

TEST(Frames, OfACommandHaveTheirOwnFiles) {
  RenderCommand command;
  command.outputs = {"a_##.png", "a_##.exr"};
  command.stats_file = "s_##.json";
  command.plan_file = "first_##.exr";
  command.preview_file = "preview.png";
  command.frames = {1, 20};
  const RenderCommand one = of_frame(command, 12);
  EXPECT_EQ(one.outputs, (std::vector<std::string>{"a_12.png", "a_12.exr"}));
  EXPECT_EQ(one.stats_file, "s_12.json");
  EXPECT_EQ(one.plan_file, "first_12.exr");
  EXPECT_EQ(one.preview_file, "preview.png");
  EXPECT_EQ(one.scene.frame, 12);
  EXPECT_FALSE(one.frames);
}

}  // namespace
}  // namespace lapidary::app
