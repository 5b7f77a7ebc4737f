// SPDX-License-Identifier: Apache-2.0
// Fixture: a session with the test runtime through the system's OpenXR loader, and a room to draw.
#pragma once

#include <cmath>
#include <cstdlib>
#include <memory>
#include <optional>

#include <gtest/gtest.h>

#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"
#include "roomcast/viewer/view/room_picture.h"
#include "roomcast/viewer/view/wall_room_fixture.h"
#include "roomcast/viewer/xr/headset.h"
#include "roomcast/viewer/xr/test_runtime/test_runtime.h"

namespace roomcast::viewer::xr {

/// A wall 2 m ahead with a red left half, a green right half, and a black border below.
inline client::RoomSnapshot two_colored_room() {
  constexpr int kSide = 96;
  ColorImage color(kSide, kSide, {200, 10, 10});
  render::fill_box<Rgb8>(color, kSide / 2, 0, kSide, kSide, {10, 190, 10});
  return room_with_wall(world_from_optical_looking_at({0, 1.6, 0}, {0, 1.6, -1}), color);
}

inline void use_test_runtime() {
  ::setenv("XR_RUNTIME_JSON", ROOMCAST_TEST_OPENXR, 1);
  ::setenv("XR_LOADER_DEBUG", "none", 1);
  ::unsetenv("XR_ENABLE_API_LAYERS");
  TestRuntime::instance().reset();
}

/// A reproducible motion of the head.
inline XrPosef nodding_head(XrTime time) {
  const double seconds = 1e-9 * static_cast<double>(time - TestRuntime::kBegin_ns);
  const auto half_yaw = static_cast<float>(0.15 * std::sin(9 * seconds));
  return {{0, std::sin(half_yaw), 0, std::cos(half_yaw)},
          {static_cast<float>(0.1 * std::sin(7 * seconds)), 1.62F, 0.05F}};
}

inline Status draw_frame(Headset& headset, RoomView& room, RoomPicture& picture) {
  const auto frame = headset.begin_frame();
  if (!frame) return frame.error();
  if (frame->is_seen) {
    if (auto status = picture.draw(room, headset.stage_eyes(), render::RenderMode::kMesh); !status)
      return status;
    headset.show(*picture.target());
  }
  return headset.end_frame();
}

class HeadsetTest : public render::GlTest {
 protected:
  void SetUp() override {
    render::GlTest::SetUp();
    use_test_runtime();
    runtime.head_at = nodding_head;
    auto made = RoomView::create();
    ASSERT_TRUE(made.ok()) << made.error().message;
    room.emplace(std::move(*made));
    ASSERT_TRUE(room->show(two_colored_room()).ok());
    picture.emplace();
  }
  void TearDown() override {
    headset.reset();
    EXPECT_EQ(runtime.open_handles, 0);
    for (const std::string& what : runtime.violations) ADD_FAILURE() << what;
    picture.reset();
    room.reset();
    render::GlTest::TearDown();
  }

  void open() {
    auto opened = Headset::open();
    ASSERT_TRUE(opened.ok()) << opened.error().message;
    headset = std::move(*opened);
    ASSERT_TRUE(headset->poll().ok());
    ASSERT_TRUE(headset->is_running());
  }
  Status draw() { return draw_frame(*headset, *room, *picture); }

  TestRuntime& runtime = TestRuntime::instance();
  std::optional<RoomView> room;
  std::optional<RoomPicture> picture;
  std::unique_ptr<Headset> headset;
};

}  // namespace roomcast::viewer::xr
