// SPDX-License-Identifier: Apache-2.0
// Tests without a camera: the library starts, and a missing camera is not found.
#include "roomcast/source/drivers/realsense/realsense_backend.h"

#include <gtest/gtest.h>

#include "roomcast/source/camera/open_camera.h"

namespace roomcast::source {
namespace {

TEST(RealSenseBackend, a_camera_that_is_not_there_is_not_found) {
  const auto backend = realsense_backend();
  EXPECT_EQ(backend->kind(), "realsense");
  ASSERT_TRUE(backend->list().ok());
  const auto opened = open_camera(*backend, "no such serial number", {});
  EXPECT_EQ(opened.error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::source
