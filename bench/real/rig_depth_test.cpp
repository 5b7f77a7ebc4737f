// SPDX-License-Identifier: Apache-2.0
#include "bench/real/rig_depth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::bench {
namespace {

TEST(RigDepthTest, a_rig_that_is_missing_is_named) {
  const TemporaryFolder folder;
  const auto depth = read_rig_depth(folder / "absent", "s0");
  ASSERT_FALSE(depth.ok());
  EXPECT_THAT(depth.error().message, testing::HasSubstr("absent"));
}

}  // namespace
}  // namespace roomcast::bench
