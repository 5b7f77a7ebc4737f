// SPDX-License-Identifier: Apache-2.0
// For tests: writes WAV files of any kind, and finds tones.
#pragma once

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/little_endian.h"

namespace roomcast::sound {

struct WavKind {
  std::uint16_t kind = 1, channels = 1, bits = 16;
  std::uint32_t rate_hz = 48'000;
};

inline std::vector<std::uint8_t> wav_bytes(const WavKind& kind,
                                           std::span<const std::uint8_t> data) {
  std::vector<std::uint8_t> bytes(44);
  const std::string riff = "RIFF", wave = "WAVEfmt ", text = "data";
  std::copy(riff.begin(), riff.end(), bytes.begin());
  write_u32(&bytes[4], static_cast<std::uint32_t>(36 + data.size()));
  std::copy(wave.begin(), wave.end(), bytes.begin() + 8);
  write_u32(&bytes[16], 16);
  write_u16(&bytes[20], kind.kind);
  write_u16(&bytes[22], kind.channels);
  write_u32(&bytes[24], kind.rate_hz);
  write_u32(&bytes[28], kind.rate_hz * kind.channels * kind.bits / 8);
  write_u16(&bytes[32], static_cast<std::uint16_t>(kind.channels * kind.bits / 8));
  write_u16(&bytes[34], kind.bits);
  std::copy(text.begin(), text.end(), bytes.begin() + 36);
  write_u32(&bytes[40], static_cast<std::uint32_t>(data.size()));
  bytes.insert(bytes.end(), data.begin(), data.end());
  return bytes;
}

inline std::vector<float> tone(double frequency_hz, double length_s, float loudness = 0.4F,
                               int rate_hz = 48'000) {
  std::vector<float> samples(static_cast<std::size_t>(length_s * rate_hz));
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = loudness * static_cast<float>(std::sin(2 * std::numbers::pi * frequency_hz *
                                                        static_cast<double>(i) / rate_hz));
  return samples;
}

/// One channel of 16 bits.
inline void write_wav(const std::filesystem::path& path, std::span<const float> samples,
                      std::uint32_t rate_hz = 48'000) {
  std::vector<std::uint8_t> data(2 * samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i)
    write_u16(&data[2 * i],
              static_cast<std::uint16_t>(static_cast<std::int16_t>(32767 * samples[i])));
  const auto bytes = wav_bytes({.rate_hz = rate_hz}, data);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()),  // NOLINT: bytes
             static_cast<std::streamsize>(bytes.size()));
}

/// Amplitude of a sine in these samples.
inline double amplitude_of(double frequency_hz, std::span<const float> samples,
                           int rate_hz = 48'000) {
  double in_phase = 0, across = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double angle = 2 * std::numbers::pi * frequency_hz * static_cast<double>(i) / rate_hz;
    in_phase += samples[i] * std::cos(angle);
    across += samples[i] * std::sin(angle);
  }
  return 2 * std::hypot(in_phase, across) / static_cast<double>(samples.size());
}

}  // namespace roomcast::sound
