// SPDX-License-Identifier: Apache-2.0
#include "roomcast/foxglove/topics.h"

#include <map>

#include <gtest/gtest.h>

#include "roomcast/recording/export/wall_fixture.h"

namespace roomcast::foxglove {
namespace {

class FoxgloveTopics : public testing::Test {
 protected:
  void SetUp() override { topics.set_sensors(recording::wall_sensors()); }

  [[nodiscard]] ChannelId id_of(const std::string& topic) const {
    for (const Channel& channel : topics.channels()) {
      if (channel.topic == topic) return channel.id;
    }
    ADD_FAILURE() << "no topic " << topic;
    return {};
  }
  [[nodiscard]] std::set<ChannelId> all() const {
    std::set<ChannelId> ids;
    for (const Channel& channel : topics.channels()) ids.insert(channel.id);
    return ids;
  }
  Status publish(const recording::FrameSet& set, const std::set<ChannelId>& wanted) {
    return topics.publish(set, wanted, [this](ChannelId channel, nanoseconds, std::string message) {
      published[channel].push_back(std::move(message));
    });
  }

  Topics topics{TopicsOptions{}};
  std::map<ChannelId, std::vector<std::string>> published;
};

TEST_F(FoxgloveTopics, a_room_has_its_cloud_its_poses_and_three_topics_for_each_sensor) {
  std::set<std::string> names;
  for (const Channel& channel : topics.channels()) names.insert(channel.topic);
  const std::set<std::string> expected = {"/points",     "/tf",          "/near/color",
                                          "/near/depth", "/near/camera", "/far/color",
                                          "/far/depth",  "/far/camera"};
  EXPECT_EQ(names, expected);
}

TEST_F(FoxgloveTopics, only_what_is_wanted_is_made) {
  ASSERT_TRUE(publish(recording::wall_set(), {id_of("/far/depth")}).ok());
  ASSERT_EQ(published.size(), 1u);
  const recording::FrameSet set = recording::wall_set();
  EXPECT_EQ(published[id_of("/far/depth")][0],
            recording::depth_message("far", set.frames[1].pictures->depth_mm, set.frames[1].time));
}

TEST_F(FoxgloveTopics, a_picture_is_sent_once) {
  const recording::FrameSet set = recording::wall_set();
  ASSERT_TRUE(publish(set, all()).ok());
  ASSERT_TRUE(publish(set, all()).ok());
  EXPECT_EQ(published.size(), 8u);
  for (const auto& [channel, messages] : published) EXPECT_EQ(messages.size(), 1u);
}

TEST_F(FoxgloveTopics, sensors_keep_their_channels_when_others_come_and_go) {
  const ChannelId near = id_of("/near/depth"), far = id_of("/far/depth");
  auto sensors = recording::wall_sensors();
  EXPECT_FALSE(topics.set_sensors(sensors));
  sensors[0].depth.fx = 61;  // calibrated anew: the same channels
  EXPECT_FALSE(topics.set_sensors(sensors));
  sensors.erase(sensors.begin());
  EXPECT_TRUE(topics.set_sensors(sensors));
  EXPECT_EQ(topics.channels().size(), 5u);
  EXPECT_EQ(id_of("/far/depth"), far);
  EXPECT_TRUE(topics.set_sensors(recording::wall_sensors()));
  EXPECT_NE(id_of("/near/depth"), near);  // IDs are not reused
}

}  // namespace
}  // namespace roomcast::foxglove
