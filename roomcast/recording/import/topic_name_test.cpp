// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/import/topic_name.h"

#include <gtest/gtest.h>

namespace roomcast::recording {
namespace {

TEST(TopicName, whole_parts_are_compared) {
  EXPECT_EQ(common_topic_parts("/left/depth", "/left/color"), 1U);
  EXPECT_EQ(common_topic_parts("/left/depth/image", "/left/depth/camera_info"), 2U);
  EXPECT_EQ(common_topic_parts("/left1/depth", "/left2/depth"), 0U);
  EXPECT_EQ(common_topic_parts("/left", "/left"), 1U);
  EXPECT_EQ(common_topic_parts("", "/left"), 0U);
}

TEST(TopicName, a_topic_is_below_another) {
  EXPECT_EQ(topic_above("/left/depth"), "/left");
  EXPECT_EQ(topic_above("/depth"), "");
  EXPECT_EQ(topic_above("depth"), "");
}

}  // namespace
}  // namespace roomcast::recording
