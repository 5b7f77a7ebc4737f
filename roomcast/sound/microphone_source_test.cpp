// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/microphone_source.h"

#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/sound/wav_fixture.h"

namespace roomcast::sound {
namespace {

TEST(MicrophoneSource, a_file_takes_the_place_of_a_microphone) {
  const TemporaryFolder folder;
  write_wav(folder / "tone.wav", tone(440, 0.1));
  for (const std::string prefix : {"wav:", ""}) {
    auto microphone = open_microphone(prefix + (folder / "tone.wav").string(), false);
    ASSERT_TRUE(microphone.ok()) << microphone.error().message;
    const auto block = (*microphone)->next({});
    ASSERT_TRUE(block.ok() && *block);
    EXPECT_NEAR(loudness_of(**block), 0.4 / std::sqrt(2), 0.01);
  }
}

TEST(MicrophoneSource, what_is_no_microphone_is_refused_with_a_sentence) {
  const TemporaryFolder folder;
  std::ofstream(folder / "text.wav") << "no sound";
  const auto fault = [](const std::string& source) {
    return open_microphone(source, true).error();
  };
  EXPECT_EQ(fault("nonsense").code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(fault("alsa:").code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(fault("wav:" + (folder / "none.wav").string()).code, ErrorCode::kNotFound);
  EXPECT_EQ(fault((folder / "text.wav").string()).message,
            (folder / "text.wav").string() + " is no WAV file");
  EXPECT_FALSE(fault("alsa:there_is_no_such_device").message.empty());
}

}  // namespace
}  // namespace roomcast::sound
