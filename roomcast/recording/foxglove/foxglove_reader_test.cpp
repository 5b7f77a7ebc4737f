// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/foxglove/foxglove_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/recording/foxglove/foxglove.pb.h"

namespace roomcast::recording {
namespace {

template <class Message>
std::vector<std::uint8_t> bytes_of(const Message& message) {
  const std::string text = message.SerializeAsString();
  return {text.begin(), text.end()};
}

foxglove::RawImage raw_image() {
  foxglove::RawImage image;
  image.mutable_timestamp()->set_seconds(1'700'000'000);
  image.mutable_timestamp()->set_nanos(123);
  image.set_frame_id("left");
  image.set_width(2), image.set_height(1), image.set_step(4);
  image.set_encoding("16UC1");
  image.set_data("abcd");
  return image;
}

TEST(FoxgloveReader, a_raw_image_has_its_time_size_and_bytes) {
  FoxgloveReader reader;
  const auto bytes = bytes_of(raw_image());
  const auto image = reader.raw_image(bytes);
  ASSERT_TRUE(image);
  EXPECT_EQ(image->header.stamp, nanoseconds(1'700'000'000'000'000'123));
  EXPECT_EQ(image->header.frame_id, "left");
  EXPECT_EQ(image->width, 2U);
  EXPECT_EQ(image->height, 1U);
  EXPECT_EQ(image->step, 4U);
  EXPECT_EQ(image->encoding, "16UC1");
  EXPECT_THAT(image->data, testing::ElementsAre('a', 'b', 'c', 'd'));
}

TEST(FoxgloveReader, a_time_that_is_none_is_zero) {
  FoxgloveReader reader;
  for (const std::int64_t seconds : {std::int64_t{-1}, std::int64_t{1} << 62U}) {
    foxglove::RawImage image = raw_image();
    image.mutable_timestamp()->set_seconds(seconds);
    EXPECT_EQ(reader.raw_image(bytes_of(image))->header.stamp, nanoseconds(0));
  }
  foxglove::RawImage timeless = raw_image();
  timeless.clear_timestamp();
  EXPECT_EQ(reader.raw_image(bytes_of(timeless))->header.stamp, nanoseconds(0));
}

TEST(FoxgloveReader, compressed_pictures_and_video_have_fields_of_their_own) {
  foxglove::CompressedImage picture;
  picture.set_frame_id("left"), picture.set_format("jpeg"), picture.set_data("j");
  foxglove::CompressedVideo video;
  video.set_frame_id("right"), video.set_format("vp9"), video.set_data("v");
  FoxgloveReader reader;
  const auto picture_bytes = bytes_of(picture), video_bytes = bytes_of(video);
  EXPECT_EQ(reader.compressed_image(picture_bytes)->format, "jpeg");
  EXPECT_THAT(reader.compressed_image(picture_bytes)->data, testing::ElementsAre('j'));
  EXPECT_EQ(reader.compressed_video(video_bytes)->header.frame_id, "right");
  EXPECT_THAT(reader.compressed_video(video_bytes)->data, testing::ElementsAre('v'));
}

TEST(FoxgloveReader, a_calibration_needs_nine_numbers_of_k) {
  foxglove::CameraCalibration camera;
  camera.set_width(4), camera.set_height(3);
  camera.set_distortion_model("plumb_bob");
  for (const double d : {0.1, 0.2, 0.3, 0.4, 0.5}) camera.add_d(d);
  FoxgloveReader reader;
  EXPECT_FALSE(reader.calibration(bytes_of(camera)));
  for (int i = 0; i < 9; ++i) camera.add_k(i);
  const auto info = reader.calibration(bytes_of(camera));
  ASSERT_TRUE(info);
  EXPECT_EQ(info->width, 4U);
  EXPECT_THAT(info->d, testing::ElementsAre(0.1, 0.2, 0.3, 0.4, 0.5));
  EXPECT_THAT(info->k, testing::ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8));
}

TEST(FoxgloveReader, transforms_come_alone_and_as_a_list) {
  foxglove::FrameTransforms list;
  foxglove::FrameTransform& one = *list.add_transforms();
  one.set_parent_frame_id("world"), one.set_child_frame_id("left");
  one.mutable_translation()->set_y(2);
  one.mutable_rotation()->set_w(1);
  FoxgloveReader reader;
  for (const auto& read : {reader.transform(bytes_of(one)), reader.transforms(bytes_of(list))}) {
    ASSERT_TRUE(read);
    ASSERT_EQ(read->size(), 1U);
    EXPECT_EQ(read->front().parent, "world");
    EXPECT_EQ(read->front().child, "left");
    EXPECT_THAT(read->front().parent_from_child.translation, testing::ElementsAre(0, 2, 0));
    EXPECT_THAT(read->front().parent_from_child.rotation_xyzw, testing::ElementsAre(0, 0, 0, 1));
  }
}

TEST(FoxgloveReader, what_is_cut_is_refused_and_the_next_message_read) {
  FoxgloveReader reader;
  const auto whole = bytes_of(raw_image());
  EXPECT_FALSE(reader.raw_image(ros::ByteView(whole).first(whole.size() - 1)));
  EXPECT_TRUE(reader.raw_image(whole));
}

}  // namespace
}  // namespace roomcast::recording
