// SPDX-License-Identifier: Apache-2.0
#include "roomcast/ros2/dds/names.h"

#include <gtest/gtest.h>

namespace roomcast::ros2 {
namespace {

TEST(Ros2Names, topics_and_types_are_named_in_dds_as_ros_names_them) {
  EXPECT_EQ(dds_topic_name("/camera/depth/image_raw"), "rt/camera/depth/image_raw");
  EXPECT_EQ(dds_type_name("sensor_msgs/msg/Image"), "sensor_msgs::msg::dds_::Image_");
}

TEST(Ros2Names, topics_are_absolute_and_of_letters_digits_and_underscores) {
  for (const char* good : {"/a", "/camera/depth/image_raw", "/_x/Y2"})
    EXPECT_TRUE(check_topic_name(good).ok()) << good;
  for (const char* bad :
       {"", "/", "a", "a/b", "/a/", "//a", "/a//b", "/2d", "/a/2d", "/a b", "/a-b", "/\xC3\xA9"})
    EXPECT_FALSE(check_topic_name(bad).ok()) << bad;
  EXPECT_FALSE(check_topic_name("/" + std::string(300, 'a')).ok());
}

TEST(Ros2Names, any_text_becomes_a_part_of_a_name) {
  for (const char* text : {"s0", "", "2", "left-hand", "a/b", "\xC3\xBC"})
    EXPECT_TRUE(check_topic_name("/" + name_part(text)).ok()) << text;
  EXPECT_EQ(name_part("left-2"), "left_2");
  EXPECT_EQ(name_part("2"), "_2");
}

}  // namespace
}  // namespace roomcast::ros2
