// SPDX-License-Identifier: Apache-2.0
// With SDL's "dummy" driver, which has one silent microphone and one loudspeaker.
#include "roomcast/viewer/voice/sound_devices.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/sound/wav_fixture.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

class SoundDevicesTest : public testing::Test {
 protected:
  SoundDevicesTest() { ::setenv("SDL_AUDIODRIVER", "dummy", 1); }
};

TEST_F(SoundDevicesTest, a_microphone_gives_sound_in_real_time) {
  auto microphone = open_microphone("default");
  ASSERT_TRUE(microphone.ok()) << microphone.error().message;
  const HostTime begin = SteadyClock().now();
  for (int i = 0; i < 10; ++i) {
    const auto block = (*microphone)->next({});
    ASSERT_TRUE(block.ok() && *block) << (block ? "it ended" : block.error().message);
    EXPECT_LE((*block)->first_sample, SteadyClock().now());
  }
  EXPECT_GE(SteadyClock().now() - begin, 150ms);
}

TEST_F(SoundDevicesTest, a_loudspeaker_takes_sound_in_real_time) {
  auto loudspeaker = open_loudspeaker("default");
  ASSERT_TRUE(loudspeaker.ok()) << loudspeaker.error().message;
  const HostTime begin = SteadyClock().now();
  for (int i = 0; i < 20; ++i) ASSERT_TRUE(*(*loudspeaker)->play({}, {}));
  EXPECT_GE(SteadyClock().now() - begin, 250ms);
}

TEST_F(SoundDevicesTest, what_is_not_there_is_named) {
  const auto microphone = open_microphone("there is no such device").error();
  EXPECT_NE(microphone.message.find("there is no such device"), std::string::npos);
  EXPECT_FALSE(open_loudspeaker("there is no such device").ok());
  EXPECT_EQ(open_microphone("none").error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(open_microphone("/none/at/all.wav").error().code, ErrorCode::kNotFound);
  ASSERT_TRUE(open_loudspeaker("none").ok());
  EXPECT_EQ(*open_loudspeaker("none"), nullptr);
  (void)sound_devices(SoundDirection::kIn);
  (void)sound_devices(SoundDirection::kOut);
}

TEST_F(SoundDevicesTest, files_take_their_place) {
  const TemporaryFolder folder;
  sound::write_wav(folder / "tone.wav", sound::tone(440, 0.1));
  EXPECT_TRUE(open_microphone((folder / "tone.wav").string()).ok());
  EXPECT_TRUE(open_loudspeaker((folder / "heard.wav").string()).ok());
  EXPECT_FALSE(open_loudspeaker((folder / "heard.wav").string()).ok()) << "it is there already";
}

}  // namespace
}  // namespace roomcast::viewer
