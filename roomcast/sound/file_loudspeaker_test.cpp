// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/file_loudspeaker.h"

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/sound/wav_sound.h"

namespace roomcast::sound {
namespace {

using namespace std::chrono_literals;

TEST(FileLoudspeaker, a_file_has_what_was_played_in_real_time) {
  const TemporaryFolder folder;
  const HostTime begin = SteadyClock().now();
  {
    auto loudspeaker = FileLoudspeaker::create(folder / "heard.wav");
    ASSERT_TRUE(loudspeaker.ok()) << loudspeaker.error().message;
    StereoBlock block{};
    block[0] = 0.5F;
    block[1] = -0.5F;
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(*(*loudspeaker)->play(block, {}));
  }
  EXPECT_GE(SteadyClock().now() - begin, 59ms);
  const auto heard = read_wav(folder / "heard.wav");
  ASSERT_TRUE(heard.ok());
  EXPECT_EQ(heard->channels, 2);
  ASSERT_EQ(heard->samples.size(), 3 * StereoBlock().size());
  EXPECT_NEAR(heard->samples[1920], 0.5, 1e-4);
  EXPECT_NEAR(heard->samples[1921], -0.5, 1e-4);
}

TEST(FileLoudspeaker, replaces_no_file_and_stops_at_once) {
  const TemporaryFolder folder;
  {
    auto loudspeaker = FileLoudspeaker::create(folder / "heard.wav");
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(*(*loudspeaker)->play({}, stop.get_token()));
  }
  EXPECT_EQ(FileLoudspeaker::create(folder / "heard.wav").error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::sound
