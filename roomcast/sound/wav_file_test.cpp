// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/wav_file.h"

#include <array>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/sound/wav_sound.h"

namespace roomcast::sound {
namespace {

TEST(WavFile, has_the_samples_and_the_silence_between_them) {
  const TemporaryFolder folder;
  const auto path = folder / "sound.wav";
  auto file = WavFile::create(path, 1);
  ASSERT_TRUE(file.ok()) << file.error().message;
  const std::array<float, 2> loud{0.5F, -0.25F};
  file->append_silence(3);
  file->append(loud);
  file->append_silence(2);
  file->append(loud);
  file->append_silence(1);
  EXPECT_FALSE(std::filesystem::exists(path)) << "it is not complete";
  ASSERT_TRUE(file->finish().ok());
  const WavSound wav = *read_wav(path);
  EXPECT_EQ(wav.channels, 1);
  const std::vector<float> expected{0, 0, 0, 0.5F, -0.25F, 0, 0, 0.5F, -0.25F, 0};
  ASSERT_EQ(wav.samples.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(wav.samples[i], expected[i], 1.0 / 32767) << i;
}

TEST(WavFile, bends_what_is_too_loud) {
  const TemporaryFolder folder;
  auto file = WavFile::create(folder / "loud.wav", 1);
  const std::array<float, 3> loud{0.9F, 2.F, -30.F};
  file->append(loud);
  ASSERT_TRUE(file->finish().ok());
  const WavSound wav = *read_wav(folder / "loud.wav");
  EXPECT_GT(wav.samples[0], 0.8F);
  EXPECT_LT(wav.samples[0], 0.9F);
  EXPECT_GT(wav.samples[1], 0.99F);
  EXPECT_NEAR(wav.samples[2], -1, 1e-4);
}

TEST(WavFile, replaces_no_other_file_and_leaves_none_that_is_not_complete) {
  const TemporaryFolder folder;
  const auto path = folder / "sound.wav";
  {
    auto file = WavFile::create(path, 2);
    ASSERT_TRUE(file.ok());
  }
  EXPECT_TRUE(std::filesystem::is_empty(path.parent_path()));
  ASSERT_TRUE(WavFile::create(path, 2)->finish().ok());
  EXPECT_EQ(WavFile::create(path, 2).error().code, ErrorCode::kUnavailable);
  EXPECT_EQ(WavFile::create(folder / "none/sound.wav", 1).error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::sound
