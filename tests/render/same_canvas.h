#pragma once

#include <gtest/gtest.h>

#include "render/canvas.h"

namespace lapidary::test {

/// All bits that two canvases could go on with, or show.
inline void expect_same(const render::Canvas& a, const render::Canvas& b) {
  EXPECT_EQ(a.film().state(), b.film().state());
  EXPECT_EQ(a.picture().state(), b.picture().state());
  ASSERT_EQ(a.plan().has_value(), b.plan().has_value());
  if (a.plan()) {
    EXPECT_EQ(a.plan()->epochs(), b.plan()->epochs());
  }
}

}  // namespace lapidary::test
