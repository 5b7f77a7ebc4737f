// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/camera/camera_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::source {
namespace {

using std::chrono::microseconds;

TEST(CameraSettings, a_trigger_delay_needs_the_secondary_role) {
  CameraSettings settings;
  EXPECT_TRUE(settings.check().ok());
  settings.trigger_delay = microseconds(160);
  EXPECT_EQ(settings.check().error().code, ErrorCode::kInvalidArgument);
  settings.sync = SyncRole::kPrimary;
  EXPECT_FALSE(settings.check().ok());
  settings.sync = SyncRole::kSecondary;
  EXPECT_TRUE(settings.check().ok());
}

TEST(CameraSettings, a_delay_is_neither_negative_nor_longer_than_a_second) {
  CameraSettings settings{.sync = SyncRole::kSecondary, .trigger_delay = kLongestTriggerDelay};
  EXPECT_TRUE(settings.check().ok());
  settings.trigger_delay += microseconds(1);
  EXPECT_FALSE(settings.check().ok());
  settings.trigger_delay = microseconds(-1);
  EXPECT_FALSE(settings.check().ok());
}

TEST(CameraSettings, settings_beyond_a_cameras_capabilities_are_refused_by_name) {
  const CameraAbilities none;
  const auto refusal = [&](const CameraSettings& settings) {
    return check_abilities("freenect", none, settings).error().message;
  };
  EXPECT_EQ(refusal({.lock_exposure = true}), "freenect cameras cannot lock their exposure");
  EXPECT_THAT(refusal({.lock_white_balance = true}), testing::HasSubstr("white balance"));
  EXPECT_THAT(refusal({.sync = SyncRole::kPrimary}), testing::HasSubstr("cable"));
  const CameraAbilities wired{.sync = true};
  const CameraSettings late{.sync = SyncRole::kSecondary, .trigger_delay = microseconds(160)};
  EXPECT_THAT(check_abilities("x", wired, late).error().message, testing::HasSubstr("trigger"));
}

TEST(CameraSettings, supported_settings_and_defaults_are_accepted) {
  EXPECT_TRUE(check_abilities("x", {}, {}).ok());
  const CameraAbilities all{true, true, true, true};
  const CameraSettings every{true, true, SyncRole::kSecondary, microseconds(160)};
  EXPECT_TRUE(check_abilities("x", all, every).ok());
}

}  // namespace
}  // namespace roomcast::source
