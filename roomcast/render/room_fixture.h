// SPDX-License-Identifier: Apache-2.0
// Fixture for tests that draw rooms: a renderer, a plain background, and the drawn picture.
#pragma once

#include <cmath>
#include <cstdint>

#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/room_renderer.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"

namespace roomcast::render {

inline constexpr Rgb8 kNothing = {3, 3, 3};
inline constexpr SensorId kFirst{1}, kSecond{2};

struct Picture {
  ColorImage color;
  Image<std::int32_t> sensors;
};

class RoomTest : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (HasFatalFailure()) return;
    Result<RoomRenderer> made = RoomRenderer::create();
    ASSERT_TRUE(made.ok()) << made.error().message;
    room_ = std::move(made).value();
    options_.background = kNothing;
    options_.floor_grid = false;
    options_.unseen = Unseen::kBackground;
    ASSERT_TRUE(room_->set_options(options_).ok());
  }

  void TearDown() override {
    room_.reset();
    GlTest::TearDown();
  }

  void add(SensorId id, const CameraIntrinsics& lens, const RigidTransform& world_from_depth,
           const SensorPictures& pictures) {
    const Status placed = room_->set_sensor(id, lens, world_from_depth);
    ASSERT_TRUE(placed.ok()) << placed.error().message;
    const Status shown = room_->upload(id, pictures.depth_mm, pictures.color, pictures.seen);
    ASSERT_TRUE(shown.ok()) << shown.error().message;
  }

  Picture draw(const ViewCamera& camera, RenderMode mode) {
    Result<OffscreenTarget> target = OffscreenTarget::create(camera.width, camera.height);
    EXPECT_TRUE(target.ok());
    const Status drawn = room_->draw(camera, *target, mode);
    EXPECT_TRUE(drawn.ok());
    return {target->read_color(), target->read_sensors()};
  }

  std::optional<RoomRenderer> room_;
  RenderOptions options_;
};

/// The eye that sees the same picture as an ideal pinhole camera at the same pose.
inline ViewCamera eye_of(const CameraIntrinsics& lens, const RigidTransform& world_from_optical) {
  ViewCamera camera;
  camera.world_from_view = world_from_optical * optical_from_view();
  camera.vertical_fov_rad = 2 * std::atan(0.5 * lens.height / lens.fy);
  camera.width = lens.width;
  camera.height = lens.height;
  return camera;
}

}  // namespace roomcast::render
