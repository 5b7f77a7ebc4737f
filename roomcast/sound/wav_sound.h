// SPDX-License-Identifier: Apache-2.0
// WavSound: what a WAV file contains (RIFF WAVE, Microsoft and IBM 1991): PCM of 8, 16, 24 or 32
// bits, or floating point. Compressed ones are not read. No state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::sound {

struct WavSound {
  int rate_hz = 0;             // 8000 to 192000
  int channels = 0;            // 1 to 8
  std::vector<float> samples;  // of all channels in turn, -1 to 1
};

inline constexpr std::size_t kMaxWavBytes = 256U << 20U;

/// kMalformed, kUnsupported: the sentence goes on after the name of a file.
[[nodiscard]] Result<WavSound> parse_wav(std::span<const std::uint8_t> file);

/// Also the errors of io::read_file.
[[nodiscard]] Result<WavSound> read_wav(const std::filesystem::path& path);

/// One channel, the mean of all, at voice::kVoiceRate_hz.
[[nodiscard]] std::vector<float> one_channel(const WavSound& sound);

}  // namespace roomcast::sound
