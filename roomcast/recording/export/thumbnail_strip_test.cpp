// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/export/thumbnail_strip.h"

#include <gtest/gtest.h>

#include "roomcast/recording/export/wall_fixture.h"

namespace roomcast::recording {
namespace {

/// The second sensor has no colour; its depth decreases from set to set.
FrameSet set_number(std::uint64_t number) {
  FrameSet set = wall_set();
  auto pictures = std::make_shared<codec::DecodedFrame>();
  pictures->depth_mm = DepthImage(64, 48, static_cast<std::uint16_t>(5000 - 40 * number));
  set.frames[1].pictures = std::move(pictures);
  return set;
}

TEST(ThumbnailStrip, shows_the_whole_recording_in_a_few_columns) {
  ThumbnailStrip strip(wall_sensors());
  for (std::uint64_t i = 0; i < 100; ++i) strip.add(set_number(i));
  const ColorImage picture = strip.picture();
  const int cell = ThumbnailStrip::kWidth + ThumbnailStrip::kGap;
  EXPECT_EQ(picture.width(), 8 * cell - ThumbnailStrip::kGap);
  EXPECT_EQ(picture.height(), 2 * 124 - ThumbnailStrip::kGap);
  EXPECT_EQ(picture.at(80, 60), (Rgb8{200, 0, 0}));
  int before = 0;
  for (int column = 0; column < 8; ++column) {
    const int bright = picture.at(column * cell + 80, 180).r;
    EXPECT_GT(bright, before);
    before = bright;
  }
  EXPECT_GT(before, 190) << "the last column is from the recording's end";
}

TEST(ThumbnailStrip, a_sensor_without_a_frame_leaves_its_place_empty) {
  ThumbnailStrip strip(wall_sensors());
  FrameSet set = wall_set();
  set.frames.erase(set.frames.begin());
  strip.add(set);
  EXPECT_EQ(strip.picture().at(80, 60), (Rgb8{255, 255, 255}));
  EXPECT_EQ(strip.picture().at(80, 180), (Rgb8{0, 200, 0}));
}

TEST(ThumbnailStrip, nothing_is_an_empty_picture) {
  EXPECT_TRUE(ThumbnailStrip(wall_sensors()).picture().empty());
  EXPECT_TRUE(ThumbnailStrip({}).picture().empty());
}

}  // namespace
}  // namespace roomcast::recording
