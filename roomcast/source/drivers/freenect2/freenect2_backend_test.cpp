// SPDX-License-Identifier: Apache-2.0
// Tests without a camera: the library starts, and a missing camera is not found.
#include "roomcast/source/drivers/freenect2/freenect2_backend.h"

#include <gtest/gtest.h>

#include "roomcast/source/camera/open_camera.h"

namespace roomcast::source {
namespace {

TEST(Freenect2Backend, a_camera_that_is_not_there_is_not_found) {
  const auto backend = freenect2_backend();
  EXPECT_EQ(backend->kind(), "freenect2");
  ASSERT_TRUE(backend->list().ok());
  const auto opened = open_camera(*backend, "no such serial number", {});
  EXPECT_EQ(opened.error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::source
