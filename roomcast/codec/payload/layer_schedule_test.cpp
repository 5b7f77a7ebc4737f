// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/payload/layer_schedule.h"

#include <string>

#include <gtest/gtest.h>

namespace roomcast::codec {
namespace {

/// One character for each frame: K, or its layer.
std::string roles(int layers, int key_interval, int frames, int wanted = -1) {
  LayerSchedule schedule(layers, key_interval);
  std::string text;
  for (int i = 0; i < frames; ++i) {
    const FrameRole role = schedule.next(i == wanted);
    text += role.key ? 'K' : static_cast<char>('0' + role.layer);
  }
  return text;
}

TEST(LayerSchedule, layers_alternate_from_each_key_frame_on) {
  EXPECT_EQ(roles(1, 100, 5), "K0000");
  EXPECT_EQ(roles(2, 100, 7), "K101010");
  EXPECT_EQ(roles(3, 100, 10), "K212021202");
}

TEST(LayerSchedule, key_frames_come_at_the_interval) {
  EXPECT_EQ(roles(2, 4, 9), "K101K101K");
  EXPECT_EQ(roles(3, 1, 3), "KKK");
}

TEST(LayerSchedule, a_wanted_key_frame_starts_the_interval_anew) {
  EXPECT_EQ(roles(2, 4, 9, 2), "K1K101K10");
}

TEST(LayerSchedule, layers_and_the_interval_can_be_changed) {
  LayerSchedule schedule(2, 100);
  const auto next = [&schedule] {
    const FrameRole role = schedule.next(false);
    return role.key ? 'K' : static_cast<char>('0' + role.layer);
  };
  std::string text;
  for (int i = 0; i < 4; ++i) text += next();
  schedule.set_layers(1);
  for (int i = 0; i < 3; ++i) text += next();
  schedule.set_layers(2);
  schedule.set_key_interval(10);
  for (int i = 0; i < 5; ++i) text += next();
  EXPECT_EQ(text, "K101000101K1");
}

}  // namespace
}  // namespace roomcast::codec
