// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/file_microphone.h"

#include <gtest/gtest.h>

namespace roomcast::sound {
namespace {

using namespace std::chrono_literals;

/// As if it had begun a while ago, so that nothing is to be waited for.
FileMicrophone begun(std::vector<float> samples, bool loops) {
  return {std::move(samples), loops, SteadyClock().now() - 500ms};
}

TEST(FileMicrophone, plays_a_file_once_and_fills_the_last_block_with_silence) {
  auto microphone = begun(std::vector<float>(1000, 0.5F), false);
  const auto first = *microphone.next({}), second = *microphone.next({});
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->samples.back(), 0.5F);
  EXPECT_EQ(second->samples[39], 0.5F);
  EXPECT_EQ(second->samples[40], 0);
  EXPECT_EQ(second->first_sample, first->first_sample + 20ms);
  EXPECT_FALSE(*microphone.next({}));
  EXPECT_NEAR(loudness_of(*first), 0.5, 1e-6);
}

TEST(FileMicrophone, plays_a_file_again_and_again_without_a_gap) {
  std::vector<float> samples(700);
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = static_cast<float>(i) / 1000;
  auto microphone = begun(samples, true);
  std::size_t at = 0;
  for (int i = 0; i < 5; ++i) {
    const auto block = *microphone.next({});
    for (const float sample : block->samples) ASSERT_EQ(sample, samples[at++ % samples.size()]);
  }
}

TEST(FileMicrophone, a_block_is_there_when_it_would_have_been_recorded) {
  FileMicrophone microphone(std::vector<float>(9600), false, SteadyClock().now());
  const HostTime begin = SteadyClock().now();
  for (int i = 0; i < 3; ++i) (void)microphone.next({});
  EXPECT_GE(SteadyClock().now() - begin, 55ms);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(*microphone.next(stop.get_token()));
}

TEST(FileMicrophone, after_a_sleep_it_does_not_say_all_that_it_missed) {
  FileMicrophone microphone(std::vector<float>(96'000), true, SteadyClock().now() - 60s);
  EXPECT_GT((*microphone.next({}))->first_sample, SteadyClock().now() - 1s);
}

}  // namespace
}  // namespace roomcast::sound
