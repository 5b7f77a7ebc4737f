// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/wav_sound.h"

#include <bit>

#include <gtest/gtest.h>

#include "roomcast/core/temporary_folder.h"
#include "roomcast/sound/wav_fixture.h"

namespace roomcast::sound {
namespace {

TEST(WavSound, samples_of_every_width_are_read) {
  const std::vector<std::uint8_t> bytes8{128, 192, 0}, bytes16{0, 0, 0, 64, 0, 128},
      bytes24{0, 0, 0, 0, 0, 64, 0, 0, 128}, bytes32{0, 0, 0, 0, 0, 0, 0, 64, 0, 0, 0, 128};
  const std::vector<std::pair<std::uint16_t, const std::vector<std::uint8_t>*>> kinds = {
      {8, &bytes8}, {16, &bytes16}, {24, &bytes24}, {32, &bytes32}};
  for (const auto& [bits, bytes] : kinds) {
    const auto sound = parse_wav(wav_bytes({.bits = bits}, *bytes));
    ASSERT_TRUE(sound.ok()) << bits;
    EXPECT_EQ(sound->samples, (std::vector<float>{0, 0.5F, -1})) << bits;
  }
}

TEST(WavSound, floating_point_is_read_and_what_is_no_number_is_silence) {
  std::vector<std::uint8_t> bytes(12);
  write_u32(&bytes[0], std::bit_cast<std::uint32_t>(0.25F));
  write_u32(&bytes[4], std::bit_cast<std::uint32_t>(NAN));
  write_u32(&bytes[8], std::bit_cast<std::uint32_t>(7.F));
  const auto sound = parse_wav(wav_bytes({.kind = 3, .bits = 32}, bytes));
  ASSERT_TRUE(sound.ok());
  EXPECT_EQ(sound->samples, (std::vector<float>{0.25F, 0, 1}));
}

TEST(WavSound, other_chunks_are_skipped_and_a_file_that_is_cut_off_has_what_is_there) {
  auto bytes = wav_bytes({.channels = 2}, std::vector<std::uint8_t>(40, 1));
  const std::vector<std::uint8_t> list{'L', 'I', 'S', 'T', 3, 0, 0, 0, 9, 9, 9, 0};
  bytes.insert(bytes.begin() + 12, list.begin(), list.end());
  bytes.resize(bytes.size() - 7);
  const auto sound = parse_wav(bytes);
  ASSERT_TRUE(sound.ok()) << sound.error().message;
  EXPECT_EQ(sound->channels, 2);
  EXPECT_EQ(sound->samples.size(), 16u);
}

TEST(WavSound, what_is_not_read_is_refused_with_a_sentence) {
  const std::vector<std::uint8_t> data(8);
  const auto fault = [](const std::vector<std::uint8_t>& bytes) {
    const auto sound = parse_wav(bytes);
    return sound ? std::string() : sound.error().message;
  };
  EXPECT_EQ(fault({1, 2, 3}), "is no WAV file");
  EXPECT_EQ(fault(wav_bytes({}, {})), "is a WAV file without sound");
  EXPECT_TRUE(fault(wav_bytes({.kind = 0x55}, data)).starts_with("is a WAV file of another kind"));
  EXPECT_TRUE(fault(wav_bytes({.channels = 0}, data)).starts_with("has more than 8 channels"));
  EXPECT_TRUE(fault(wav_bytes({.rate_hz = 1}, data)).starts_with("has a sample rate"));
  auto without_data = wav_bytes({}, data);
  without_data.resize(36);
  EXPECT_TRUE(fault(without_data).starts_with("is a damaged WAV file"));
  for (std::size_t length = 0; length < 52; ++length) {
    auto cut = wav_bytes({}, data);
    cut.resize(length);
    (void)fault(cut);
  }
}

TEST(WavSound, a_file_becomes_one_channel_at_48_kHz) {
  const TemporaryFolder folder;
  write_wav(folder / "tone.wav", tone(440, 0.5, 0.4F, 16'000), 16'000);
  const auto sound = read_wav(folder / "tone.wav");
  ASSERT_TRUE(sound.ok());
  const std::vector<float> samples = one_channel(*sound);
  EXPECT_EQ(samples.size(), 24'000u);
  EXPECT_NEAR(amplitude_of(440, samples), 0.4, 0.01);
  EXPECT_EQ(read_wav(folder / "none.wav").error().code, ErrorCode::kNotFound);
  EXPECT_EQ(one_channel({48'000, 2, {1, 0, 0.5F, -0.5F}}), (std::vector<float>{0.5F, 0}));
}

}  // namespace
}  // namespace roomcast::sound
