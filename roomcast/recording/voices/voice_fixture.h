// SPDX-License-Identifier: Apache-2.0
// For tests: a voice that says what is asked of it, as packets of Opus, and WAV files to look at.
#pragma once

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <opus/opus.h>

#include "roomcast/core/little_endian.h"
#include "roomcast/voice/voice_decoder.h"

namespace roomcast::recording {

/// Encodes as the page does: 32 kbit/s, 20 ms, one channel.
class VoiceFixture {
 public:
  using Sound = std::function<float(std::int64_t sample)>;

  explicit VoiceFixture(Sound sound) : sound_(std::move(sound)) {
    int fault = OPUS_OK;
    encoder_ = opus_encoder_create(voice::kVoiceRate_hz, 1, OPUS_APPLICATION_AUDIO, &fault);
    EXPECT_EQ(fault, OPUS_OK);
    opus_encoder_ctl(encoder_, OPUS_SET_BITRATE(32'000));
    opus_int32 delay = 0;
    opus_encoder_ctl(encoder_, OPUS_GET_LOOKAHEAD(&delay));
    EXPECT_EQ(delay, voice::kEncoderDelaySamples);
  }
  ~VoiceFixture() { opus_encoder_destroy(encoder_); }
  VoiceFixture(const VoiceFixture&) = delete;
  VoiceFixture& operator=(const VoiceFixture&) = delete;

  std::vector<std::uint8_t> next_packet() {
    std::array<float, voice::kPacketSamples> samples{};
    for (float& sample : samples) sample = sound_(said_++);
    std::vector<std::uint8_t> packet(1275);
    const int length = opus_encode_float(encoder_, samples.data(), voice::kPacketSamples,
                                         packet.data(), static_cast<opus_int32>(packet.size()));
    EXPECT_GT(length, 0);
    packet.resize(static_cast<std::size_t>(std::max(length, 0)));
    return packet;
  }

  /// 440 Hz at this loudness.
  static Sound tone(float loudness) {
    return [loudness](std::int64_t sample) {
      return loudness *
             std::sin(2 * std::numbers::pi_v<float> * 440 *
                      static_cast<float>(sample % voice::kVoiceRate_hz) / voice::kVoiceRate_hz);
    };
  }

 private:
  Sound sound_;
  OpusEncoder* encoder_ = nullptr;
  std::int64_t said_ = 0;
};

struct ReadWav {
  int channels = 0;
  std::vector<float> samples;  // of all channels in turn

  [[nodiscard]] std::size_t length() const {
    return samples.size() / static_cast<std::size_t>(channels);
  }
  /// Root of the mean square of a channel between two times.
  [[nodiscard]] double loudness(double from_s, double to_s, int channel = 0) const {
    double sum = 0;
    std::size_t count = 0;
    const auto at = [](double s) { return static_cast<std::size_t>(s * voice::kVoiceRate_hz); };
    for (std::size_t i = at(from_s); i < std::min(at(to_s), length()); ++i, ++count) {
      const float value =
          samples[i * static_cast<std::size_t>(channels) + static_cast<std::size_t>(channel)];
      sum += value * value;
    }
    return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));
  }
};

inline ReadWav read_wav(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> chars{std::istreambuf_iterator<char>(file),
                                std::istreambuf_iterator<char>()};
  const std::vector<std::uint8_t> bytes(chars.begin(), chars.end());
  EXPECT_GE(bytes.size(), 44u) << path;
  if (bytes.size() < 44) return {};
  EXPECT_EQ(std::string(chars.begin(), chars.begin() + 4), "RIFF");
  EXPECT_EQ(read_u32(&bytes[4]), bytes.size() - 8);
  EXPECT_EQ(read_u32(&bytes[24]), static_cast<std::uint32_t>(voice::kVoiceRate_hz));
  EXPECT_EQ(read_u32(&bytes[40]), bytes.size() - 44);
  ReadWav wav{.channels = read_u16(&bytes[22]), .samples = {}};
  for (std::size_t i = 44; i + 1 < bytes.size(); i += 2)
    wav.samples.push_back(static_cast<float>(static_cast<std::int16_t>(read_u16(&bytes[i]))) /
                          32767);
  return wav;
}

}  // namespace roomcast::recording
