// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/settings_check.h"

#include <limits>

#include <gtest/gtest.h>

#include "roomcast/wire/control_check.h"
#include "roomcast/wire/limits.h"

namespace roomcast::wire {
namespace {

pb::Control request_for(const pb::SensorSettings& settings) {
  pb::Control control;
  *control.mutable_settings_request()->mutable_settings() = settings;
  return control;
}

TEST(SettingsCheck, settings_may_be_none_and_name_codecs_of_later_versions) {
  pb::SensorSettings settings;
  EXPECT_TRUE(check_control(request_for(settings)).ok());
  settings.set_codec("wavelet");
  settings.set_mbit(2.5);
  settings.set_fps(30);
  EXPECT_TRUE(check_control(request_for(settings)).ok());
}

TEST(SettingsCheck, settings_out_of_range_are_refused) {
  pb::SensorSettings settings;
  for (const double mbit : {-1.0, 1001.0, std::numeric_limits<double>::quiet_NaN()}) {
    settings.set_mbit(mbit);
    EXPECT_FALSE(check_control(request_for(settings)).ok()) << mbit;
  }
  settings.clear_mbit();
  for (const double fps : {0.0, 241.0, std::numeric_limits<double>::infinity()}) {
    settings.set_fps(fps);
    EXPECT_FALSE(check_control(request_for(settings)).ok()) << fps;
  }
  settings.clear_fps();
  settings.set_codec(std::string(kMaxNameBytes + 1, 'x'));
  EXPECT_FALSE(check_control(request_for(settings)).ok());
}

TEST(SettingsCheck, a_refusal_has_an_end) {
  pb::Control control;
  control.mutable_settings_answer()->set_refusal(std::string(kMaxNoteBytes, 'x'));
  EXPECT_TRUE(check_control(control).ok());
  control.mutable_settings_answer()->set_refusal(std::string(kMaxNoteBytes + 1, 'x'));
  EXPECT_FALSE(check_control(control).ok());
}

}  // namespace
}  // namespace roomcast::wire
