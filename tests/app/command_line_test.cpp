#include "app/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lapidary::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

template <typename Kind>
Kind parse(std::vector<std::string> arguments) {
  return std::get<Kind>(parse_command_line(std::move(arguments)));
}

std::string problem_of(std::vector<std::string> arguments) {
  try {
    parse_command_line(std::move(arguments));
  } catch (const UsageError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(CommandLine, ReadsARenderCommand) {
  const auto c = parse<RenderCommand>({"render", "a.lua", "-o", "b.png", "-o", "c.exr", "--threads",
                                       "2", "--stats", "s.json", "--progress", "json"});
  EXPECT_EQ(c.scene.file, "a.lua");
  EXPECT_THAT(c.outputs, ElementsAre("b.png", "c.exr"));
  EXPECT_EQ(c.threads, 2);
  EXPECT_EQ(c.stats_file, "s.json");
  EXPECT_EQ(c.progress, ProgressStyle::json);
}

TEST(CommandLine, Frames) {
  const auto c = parse<RenderCommand>(
      {"render", "a.lua", "-o", "a_####.png", "--frames", "3-17", "--fps", "25"});
  ASSERT_TRUE(c.frames);
  EXPECT_EQ(c.frames->first, 3);
  EXPECT_EQ(c.frames->last, 17);
  EXPECT_EQ(c.scene.fps, 25);
  EXPECT_FALSE(c.scene.frame);
  EXPECT_EQ(parse<RenderCommand>({"render", "a.lua", "--frame", "7"}).scene.frame, 7);
  EXPECT_EQ(parse<CheckCommand>({"check", "a.lua", "--frame", "7"}).scene.frame, 7);
}

TEST(CommandLine, FramesThatMakeNoSense) {
  const auto problem = [](std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "a.lua"});
    return problem_of(options);
  };
  for (const char* range : {"3-2", "-1-3", "a-b", "1-", "-", "1-2-3", "1-99999999", "1.5"}) {
    EXPECT_THAT(problem({"-o", "#.png", "--frames", range}), HasSubstr("0 <= A <= B")) << range;
  }
  EXPECT_THAT(problem({"--frames", "1-2"}), HasSubstr("names for the pictures"));
  EXPECT_THAT(problem({"--frames", "1-2", "-o", "#.png", "-o", "a.exr"}), HasSubstr("-o a.exr"));
  EXPECT_THAT(problem({"--frames", "1-2", "-o", "#.png", "--stats", "s.json"}),
              HasSubstr("--stats s.json"));
  EXPECT_THAT(problem({"--frames", "1-2", "-o", "#.png", "--frame", "1"}),
              HasSubstr("do not go together"));
  EXPECT_THAT(problem({"--frame", "-1"}), HasSubstr("--frame"));
  EXPECT_THAT(problem({"--fps", "0"}), HasSubstr("--fps"));
}

TEST(CommandLine, ReadsWhatLongRendersTake) {
  const auto c = parse<RenderCommand>({"render", "a.lua", "--resume", "--checkpoint", "2.5",
                                       "--blocks", "5-8", "--plan", "first.exr"});
  EXPECT_TRUE(c.resumes);
  EXPECT_EQ(c.checkpoint_seconds, 2.5);
  ASSERT_TRUE(c.blocks);
  EXPECT_EQ(c.blocks->first, 5u);
  EXPECT_EQ(c.blocks->last, 8u);
  EXPECT_EQ(c.plan_file, "first.exr");
  EXPECT_EQ(parse<RenderCommand>({"render", "a.lua", "--blocks", "7"}).blocks->last, 7u);
  EXPECT_FALSE(parse<RenderCommand>({"render", "a.lua"}).checkpoint_seconds);
  const auto m = parse<MergeCommand>({"merge", "a.exr", "b.exr", "-o", "c.exr", "-o", "c.png"});
  EXPECT_THAT(m.parts, ElementsAre("a.exr", "b.exr"));
  EXPECT_THAT(m.outputs, ElementsAre("c.exr", "c.png"));
  EXPECT_THAT(problem_of({"render", "a.lua", "--blocks", "4-3"}), HasSubstr("1 <= A <= B"));
  EXPECT_THAT(problem_of({"render", "a.lua", "--plan", "a.exr"}), HasSubstr("--blocks"));
}

TEST(CommandLine, OptionsMayComeBeforeTheScene) {
  const auto c = parse<RenderCommand>({"render", "-o", "b.png", "--set", "n=3", "a.lua"});
  EXPECT_EQ(c.scene.file, "a.lua");
  EXPECT_THAT(c.outputs, ElementsAre("b.png"));
}

TEST(CommandLine, ShortFormsAreSettings) {
  const auto c = parse<RenderCommand>({"render", "a.lua", "--samples", "16", "--size", "4x3",
                                       "--render", "max_depth=8", "--time", "2.5", "--noise", "0.1",
                                       "--seed", "7", "--integrator", "direct"});
  EXPECT_THAT(c.settings,
              testing::UnorderedElementsAre(Assignment{"samples", "16"}, Assignment{"size", "4x3"},
                                            Assignment{"max_depth", "8"}, Assignment{"time", "2.5"},
                                            Assignment{"noise", "0.1"}, Assignment{"seed", "7"},
                                            Assignment{"integrator", "direct"}));
}

TEST(CommandLine, AssignmentsSplitAtTheFirstEqualsSign) {
  const auto c = parse<RenderCommand>({"render", "a.lua", "--set", "a=b=c", "--set", "empty="});
  EXPECT_THAT(c.scene.parameters, ElementsAre(Assignment{"a", "b=c"}, Assignment{"empty", ""}));
}

TEST(CommandLine, ReadsACompareCommand) {
  const auto c = parse<CompareCommand>(
      {"compare", "a.exr", "b.exr", "--metric", "flip", "--trim", "0.001", "--crop", "1,2,30,40"});
  EXPECT_EQ(c.options.metric, image::Metric::flip);
  EXPECT_DOUBLE_EQ(c.options.trim, 0.001);
  ASSERT_TRUE(c.options.crop);
  EXPECT_EQ(c.options.crop->x, 1);
  EXPECT_EQ(c.options.crop->y, 2);
  EXPECT_EQ(c.options.crop->width, 30);
  EXPECT_EQ(c.options.crop->height, 40);
}

TEST(CommandLine, ReadsAProbeCommand) {
  const auto c = parse<ProbeCommand>({"probe", "a.lua", "--ray", "1, -2e3,3\t4 5 ,.6"});
  ASSERT_TRUE(c.ray);
  EXPECT_EQ(c.ray->origin, Vec3d(1, -2000, 3));
  EXPECT_EQ(c.ray->direction, Vec3d(4, 5, 0.6));
  EXPECT_EQ(parse<ProbeCommand>({"probe", "a.lua", "--rays", "r.txt"}).rays_file, "r.txt");
  for (const char* ray :
       {"", "1,2,3,4,5", "1,2,3,4,5,6,7", "0,0,0,0,0,0", "a,b,c,d,e,f", "1,2,3,4,5,6x",
        "1,2,3,4,5,6,", ",1,2,3,4,5,6", "1,,2,3,4,5,6", "1,2,3,4,5,nan", "1,2,3,4,5,inf",
        "0,0,0,1e-300,0,0", "1e200,0,0,1,0,0", "1,2,3,4-5,6", "1,2,3,4,5,1e999"}) {
    EXPECT_THAT(problem_of({"probe", "a.lua", "--ray", ray}), HasSubstr("--ray takes")) << ray;
  }
  EXPECT_EQ(problem_of({"probe", "a.lua"}), "a ray is missing");
  EXPECT_THAT(problem_of({"probe", "a.lua", "--ray", "0,0,0,0,0,1", "--rays", "b"}),
              HasSubstr("do not go together"));
}

TEST(CommandLine, SaysWhatIsWrong) {
  EXPECT_EQ(problem_of({}), "a verb is missing");
  EXPECT_EQ(problem_of({"paint"}), "unknown verb 'paint'");
  EXPECT_EQ(problem_of({"render"}), "SCENE is missing");
  EXPECT_EQ(problem_of({"render", "a.lua", "b.lua"}), "unexpected argument 'b.lua'");
  EXPECT_EQ(problem_of({"render", "a.lua", "--sampels", "3"}), "unknown option '--sampels'");
  EXPECT_THAT(problem_of({"render", "a.lua", "-o"}), HasSubstr("-o"));
  EXPECT_EQ(problem_of({"render", "a.lua", "--set", "n"}), "--set takes NAME=VALUE, not 'n'");
  EXPECT_EQ(problem_of({"render", "a.lua", "--render", "=3"}),
            "--render takes NAME=VALUE, not '=3'");
  EXPECT_THAT(problem_of({"render", "a.lua", "--progress", "pie"}), HasSubstr("bar, lines, json"));
  for (const char* threads : {"0", "-1", "two", "1.5", "", "99999999999"}) {
    EXPECT_THAT(problem_of({"render", "a.lua", "--threads", threads}),
                HasSubstr("--threads takes"));
  }
  for (const char* trim : {"1", "-0.1", "nan", "x"}) {
    EXPECT_THAT(problem_of({"compare", "a", "b", "--trim", trim}), HasSubstr("--trim takes"));
  }
  for (const char* crop : {"1,2,3", "1,2,3,4,5", "1,2,3,x", ""}) {
    EXPECT_THAT(problem_of({"compare", "a", "b", "--crop", crop}), HasSubstr("--crop takes"));
  }
}

TEST(CommandLine, EveryVerbExplainsItself) {
  for (const char* verb : {"render", "check", "probe", "compare", "help"}) {
    const auto text = help_of_verb(verb);
    ASSERT_TRUE(text) << verb;
    EXPECT_THAT(*text, HasSubstr(std::string("lapidary ") + verb));
    EXPECT_THAT(usage(), HasSubstr(verb));
  }
  EXPECT_FALSE(help_of_verb("sphere"));
}

}  // namespace
}  // namespace lapidary::app
