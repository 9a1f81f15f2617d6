#include "base/error.h"

#include <gtest/gtest.h>

#include "base/log.h"

namespace lapidary {
namespace {

TEST(Error, SaysWhereWhatAndWhatToDo) {
  const Error error({.file = "scene.lua", .line = 3, .column = 7}, "unknown node 'spere'",
                    "did you mean 'sphere'?");
  EXPECT_STREQ(error.what(), "scene.lua:3:7: unknown node 'spere' (did you mean 'sphere'?)");
}

TEST(Error, LeavesOutWhatIsUnknown) {
  EXPECT_STREQ(Error({}, "no scene").what(), "no scene");
  EXPECT_STREQ(file_error("a.obj", "is empty").what(), "a.obj: is empty");
  EXPECT_EQ(to_string(Location{.line = 4}), "line 4");
}

TEST(WarningLog, KeepsOrderAndIsEmptiedByTake) {
  WarningLog log;
  log.add({.file = "a"}, "first");
  log.add({}, "second");
  const auto warnings = log.take();
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(to_string(warnings[0]), "a: first");
  EXPECT_EQ(to_string(warnings[1]), "second");
  EXPECT_TRUE(log.take().empty());
}

}  // namespace
}  // namespace lapidary
