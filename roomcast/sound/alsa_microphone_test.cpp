// SPDX-License-Identifier: Apache-2.0
// With ALSA's "null" device and its plugin "file" in the place of a sound card.
#include "roomcast/sound/alsa_microphone.h"

#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/sound/wav_fixture.h"

namespace roomcast::sound {
namespace {

using namespace std::chrono_literals;

TEST(AlsaMicrophone, a_device_gives_its_sound_in_real_time) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> raw;
  for (const float sample : tone(440, 2)) {
    raw.resize(raw.size() + 2);
    write_u16(&raw[raw.size() - 2],
              static_cast<std::uint16_t>(static_cast<std::int16_t>(32767 * sample)));
  }
  std::ofstream(folder / "tone.raw", std::ios::binary)
      .write(reinterpret_cast<const char*>(raw.data()), static_cast<std::streamsize>(raw.size()));
  std::ofstream(folder / "asound.conf")
      << "pcm.room { type file slave.pcm { type null } file /dev/null infile \""
      << (folder / "tone.raw").string() << "\" format raw }\n";
  ::setenv("ALSA_CONFIG_PATH", (folder / "asound.conf").c_str(), 1);
  auto microphone = AlsaMicrophone::open("room");
  ASSERT_TRUE(microphone.ok()) << microphone.error().message;
  const HostTime begin = SteadyClock().now();
  std::vector<float> heard;
  std::optional<HostTime> expected;
  for (int i = 0; i < 10; ++i) {
    const auto block = (*microphone)->next({});
    ASSERT_TRUE(block.ok() && *block) << (block ? "it ended" : block.error().message);
    heard.insert(heard.end(), (*block)->samples.begin(), (*block)->samples.end());
    const HostTime first = (*block)->first_sample;
    EXPECT_NEAR(static_cast<double>((first - expected.value_or(first)).count()), 0, 2e6);
    expected = first + 20ms;
  }
  EXPECT_GE(SteadyClock().now() - begin, 150ms) << "no faster than it was recorded";
  EXPECT_NEAR(amplitude_of(440, heard), 0.4, 0.02);
  ::unsetenv("ALSA_CONFIG_PATH");
}

TEST(AlsaMicrophone, a_device_that_is_not_there_is_named) {
  const auto fault = AlsaMicrophone::open("there_is_no_such_device").error();
  EXPECT_EQ(fault.code, ErrorCode::kNotFound);
  EXPECT_NE(fault.message.find("there_is_no_such_device"), std::string::npos);
  (void)alsa_inputs();
}

}  // namespace
}  // namespace roomcast::sound
