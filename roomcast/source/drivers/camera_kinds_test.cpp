// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/camera_kinds.h"

#include <gtest/gtest.h>

namespace roomcast::source {
namespace {

TEST(CameraKinds, are_found_by_the_name_their_specs_begin_with) {
  ASSERT_NE(camera_kind("freenect"), nullptr);
  EXPECT_EQ(camera_kind("freenect")->library, "libfreenect");
  EXPECT_EQ(camera_kind("sim"), nullptr);
  EXPECT_EQ(camera_kind(""), nullptr);
}

TEST(CameraKinds, those_built_in_answer_to_their_names) {
  for (const CameraKind& kind : camera_kinds()) {
    if (kind.make == nullptr) continue;
    EXPECT_EQ(kind.make()->kind(), kind.name);
  }
}

}  // namespace
}  // namespace roomcast::source
