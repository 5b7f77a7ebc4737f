// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/remote_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::sensor {
namespace {

using testing::HasSubstr;

const RemoteSettings kSimulated{.codec = {}, .fps = 15};

std::string settings_refusal(const RemoteSettings& now, const wire::pb::SensorSettings& wanted) {
  const auto result = changed(now, wanted);
  return result ? "" : result.error().message;
}

TEST(RemoteSettings, what_is_not_asked_for_stays) {
  wire::pb::SensorSettings wanted;
  wanted.set_mbit(2);
  const auto settings = changed(kSimulated, wanted);
  ASSERT_TRUE(settings.ok());
  EXPECT_EQ(settings->codec.target_mbit_per_s, 2);
  EXPECT_EQ(settings->codec.depth_mode, codec::DepthMode::kLive);
  EXPECT_EQ(settings->fps, 15);
}

TEST(RemoteSettings, are_told_as_they_are_and_come_back) {
  wire::pb::SensorSettings wanted;
  wanted.set_codec("near-lossless");
  wanted.set_fps(10);
  const auto settings = changed(kSimulated, wanted);
  ASSERT_TRUE(settings.ok());
  const auto told = message_from(*settings);
  EXPECT_EQ(told.codec(), "near-lossless");
  EXPECT_EQ(told.fps(), 10);
  EXPECT_EQ(told.mbit(), 0);
  EXPECT_FALSE(message_from({}).has_fps());
}

TEST(RemoteSettings, what_the_sensor_cannot_do_is_refused_with_a_sentence) {
  wire::pb::SensorSettings wanted;
  wanted.set_codec("wavelet");
  EXPECT_THAT(settings_refusal(kSimulated, wanted), HasSubstr("has the codecs"));
  wanted.set_codec("lossless");
  wanted.set_mbit(2);
  EXPECT_THAT(settings_refusal(kSimulated, wanted), HasSubstr("needs live depth"));
  wanted.Clear();
  wanted.set_mbit(500);
  EXPECT_THAT(settings_refusal(kSimulated, wanted), HasSubstr("0.1 to 100"));
  wanted.Clear();
  wanted.set_fps(10);
  EXPECT_THAT(settings_refusal({}, wanted), HasSubstr("only a simulated sensor"));
  wanted.set_fps(100);
  EXPECT_THAT(settings_refusal(kSimulated, wanted), HasSubstr("1 to 60"));
}

TEST(SettingsMailbox, has_the_newest_request_once) {
  SettingsMailbox mailbox;
  EXPECT_FALSE(mailbox.take());
  wire::pb::SettingsRequest request;
  for (const int number : {1, 2}) {
    request.set_number(static_cast<std::uint32_t>(number));
    mailbox.put(request);
  }
  EXPECT_EQ(mailbox.take()->number(), 2U);
  EXPECT_FALSE(mailbox.take());
}

}  // namespace
}  // namespace roomcast::sensor
