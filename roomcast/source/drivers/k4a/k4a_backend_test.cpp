// SPDX-License-Identifier: Apache-2.0
// Tests without a camera: the library starts, and a missing camera is not found.
#include "roomcast/source/drivers/k4a/k4a_backend.h"

#include <gtest/gtest.h>

#include "roomcast/source/camera/open_camera.h"

namespace roomcast::source {
namespace {

TEST(K4aBackend, a_camera_that_is_not_there_is_not_found) {
  const auto backend = k4a_backend();
  EXPECT_EQ(backend->kind(), "k4a");
  ASSERT_TRUE(backend->list().ok());
  const auto opened = open_camera(*backend, "no such serial number", {});
  EXPECT_EQ(opened.error().code, ErrorCode::kNotFound);
}

}  // namespace
}  // namespace roomcast::source
