// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/preview.h"

#include <gtest/gtest.h>

#include "roomcast/io/image_file.h"
#include "roomcast/recording/dataset/recording_fixture.h"

namespace roomcast::sensor {
namespace {

TEST(Preview, near_is_red_far_is_blue_and_no_reading_is_black) {
  EXPECT_EQ(color_of_depth(0), (Rgb8{0, 0, 0}));
  EXPECT_EQ(color_of_depth(500), (Rgb8{255, 0, 0}));
  EXPECT_EQ(color_of_depth(200), (Rgb8{255, 0, 0}));
  EXPECT_EQ(color_of_depth(5000), (Rgb8{0, 0, 255}));
  EXPECT_GT(color_of_depth(900).g, 200);
}

TEST(Preview, shows_colour_beside_distance) {
  const TemporaryFolder folder;
  Preview preview(folder / "now.jpg");
  const DepthImage depth(32, 16, 500);
  const ColorImage color(32, 16, Rgb8{0, 200, 0});
  ASSERT_TRUE(preview.show(depth, color, HostTime(std::chrono::seconds(5))).ok());
  ColorImage picture;
  ASSERT_TRUE(io::ImageFileReader().read_color(folder / "now.jpg", {64, 16}, picture).ok());
  EXPECT_NEAR(picture.at(8, 8).g, 200, 10);
  EXPECT_NEAR(picture.at(56, 8).r, 255, 10);
}

TEST(Preview, colour_twice_as_fine_is_shown_too) {
  const TemporaryFolder folder;
  Preview preview(folder / "now.jpg");
  const DepthImage depth(32, 16, 500);
  const ColorImage color(64, 32, Rgb8{0, 200, 0});
  ASSERT_TRUE(preview.show(depth, color, HostTime(std::chrono::seconds(5))).ok());
  ColorImage picture;
  ASSERT_TRUE(io::ImageFileReader().read_color(folder / "now.jpg", {64, 16}, picture).ok());
  EXPECT_NEAR(picture.at(24, 12).g, 200, 10);
}

TEST(Preview, is_written_once_a_second) {
  const TemporaryFolder folder;
  Preview preview(folder / "now.jpg");
  const DepthImage depth(32, 16, 500);
  const auto show_at = [&](int ms) {
    EXPECT_TRUE(preview.show(depth, ColorView{}, HostTime(std::chrono::milliseconds(ms))).ok());
    const bool written = std::filesystem::exists(folder / "now.jpg");
    std::filesystem::remove(folder / "now.jpg");
    return written;
  };
  EXPECT_TRUE(show_at(5000));
  EXPECT_FALSE(show_at(5900));
  EXPECT_TRUE(show_at(6000));
}

TEST(Preview, a_file_that_cannot_be_written_says_so) {
  Preview preview("/nowhere/now.jpg");
  EXPECT_FALSE(preview.show(DepthImage(4, 4), ColorView{}, HostTime{}).ok());
}

}  // namespace
}  // namespace roomcast::sensor
