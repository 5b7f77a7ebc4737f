// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/ros/messages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/ros/ros_fixture.h"

namespace roomcast::recording::ros {
namespace {

ByteView view(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

class RosMessages : public testing::TestWithParam<Serialisation> {};
INSTANTIATE_TEST_SUITE_P(Both, RosMessages,
                         testing::Values(Serialisation::kRos1, Serialisation::kRos2));

TEST_P(RosMessages, pictures_are_read) {
  const nanoseconds stamp = std::chrono::seconds(1'700'000'000) + nanoseconds(5);
  const std::string message =
      image_message(GetParam(), stamp, "optical", 3, 2, "16UC1", 6, "abcdefghijkl");
  const auto image = read_image(view(message), GetParam());
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.stamp, stamp);
  EXPECT_EQ(image->header.frame_id, "optical");
  EXPECT_EQ(image->width, 3U);
  EXPECT_EQ(image->height, 2U);
  EXPECT_EQ(image->encoding, "16UC1");
  EXPECT_EQ(image->step, 6U);
  EXPECT_EQ(std::string(image->data.begin(), image->data.end()), "abcdefghijkl");
  const std::string small = compressed_message(GetParam(), stamp, "f", "jpeg", "xyz");
  const auto compressed = read_compressed_image(view(small), GetParam());
  ASSERT_TRUE(compressed);
  EXPECT_EQ(compressed->format, "jpeg");
  EXPECT_EQ(compressed->data.size(), 3U);
}

TEST_P(RosMessages, cameras_and_transforms_are_read) {
  const std::string message =
      camera_info_message(GetParam(), "odd", 640, 480, 525, "plumb_bob", {0.1, -0.2, 0, 0, 0.3});
  const auto info = read_camera_info(view(message), GetParam());
  ASSERT_TRUE(info);
  EXPECT_EQ(info->width, 640U);
  EXPECT_EQ(info->distortion_model, "plumb_bob");
  EXPECT_THAT(info->d, testing::ElementsAre(0.1, -0.2, 0, 0, 0.3));
  EXPECT_EQ(info->k[0], 525);
  EXPECT_EQ(info->k[5], 239.5);
  EXPECT_EQ(info->p[6], 239.5);
  const std::string tree = transforms_message(
      GetParam(), {{"base", "depth", {1, 2, 3}}, {"depth", "optical", {0, 0, 0.5}}});
  const auto transforms = read_transforms(view(tree), GetParam());
  ASSERT_TRUE(transforms);
  ASSERT_EQ(transforms->size(), 2U);
  EXPECT_EQ((*transforms)[1].parent, "depth");
  EXPECT_EQ((*transforms)[1].child, "optical");
  EXPECT_EQ((*transforms)[1].parent_from_child.translation[2], 0.5);
  EXPECT_EQ((*transforms)[1].parent_from_child.rotation_xyzw[3], 1);
}

TEST_P(RosMessages, cut_anywhere_they_are_refused) {
  const std::string message = camera_info_message(GetParam(), "odd", 640, 480, 525, "m", {0.1});
  for (std::size_t size = 0; size < message.size(); ++size)
    EXPECT_FALSE(read_camera_info(view(message.substr(0, size)), GetParam())) << size;
  const std::string tree = transforms_message(GetParam(), {{"a", "b", {}}});
  for (std::size_t size = 0; size < tree.size(); ++size)
    EXPECT_FALSE(read_transforms(view(tree.substr(0, size)), GetParam())) << size;
}

TEST(RosMessages, counts_that_cannot_be_are_refused_before_anything_is_allocated) {
  const std::string many("\xFF\xFF\xFF\xFF", 4);
  EXPECT_FALSE(read_transforms(view(many), Serialisation::kRos1));
  EXPECT_FALSE(read_image(view(many), Serialisation::kRos1));
  EXPECT_FALSE(read_image(view(std::string("\0\7\0\0xxxx", 8)), Serialisation::kRos2));
}

TEST(RosMessages, cdr_may_be_big_endian) {
  const std::string message(
      "\0\0\0\0"
      "\0\0\0\5"
      "\0\0\0\7"
      "\0\0\0\2f\0",
      18);
  MessageReader reader(view(message), Serialisation::kRos2);
  const auto header = reader.header();
  EXPECT_TRUE(reader.ok());
  EXPECT_EQ(header.stamp, std::chrono::seconds(5) + nanoseconds(7));
  EXPECT_EQ(header.frame_id, "f");
}

}  // namespace
}  // namespace roomcast::recording::ros
