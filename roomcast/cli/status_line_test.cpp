// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/status_line.h"

#include <gtest/gtest.h>

namespace roomcast::cli {
namespace {

using Seconds = std::chrono::duration<double>;

TEST(ProgressText, shows_how_much_is_done_and_the_time_left) {
  EXPECT_EQ(progress_text("writing frames", 135, 450, Seconds(6)),
            "writing frames [######--------------] 135 of 450, 14 s left");
  EXPECT_EQ(progress_text("tracing", 1, 100, Seconds(5)),
            "tracing [--------------------] 1 of 100, 8 min 15 s left");
}

TEST(ProgressText, shows_no_time_left_before_it_can_be_estimated) {
  EXPECT_EQ(progress_text("tracing", 0, 3, Seconds(60)), "tracing [--------------------] 0 of 3");
  EXPECT_EQ(progress_text("tracing", 1, 4, Seconds(0.1)), "tracing [#####---------------] 1 of 4");
}

TEST(ProgressText, ends_full_and_without_a_time) {
  EXPECT_EQ(progress_text("tracing", 3, 3, Seconds(9)), "tracing [####################] 3 of 3");
  EXPECT_EQ(progress_text("tracing", 0, 0, Seconds(9)), "tracing [####################] 0 of 0");
}

}  // namespace
}  // namespace roomcast::cli
