// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/wav_sound.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "roomcast/core/little_endian.h"
#include "roomcast/io/file_bytes.h"
#include "roomcast/sound/resampling.h"
#include "roomcast/voice/voice_decoder.h"

namespace roomcast::sound {
namespace {

constexpr std::uint16_t kPcm = 1, kFloat = 3, kExtensible = 0xFFFE;
constexpr int kMaxChannels = 8;

struct WavFormat {
  std::uint16_t kind = 0, channels = 0, bits = 0;
  std::uint32_t rate_hz = 0;
};

using Bytes = std::span<const std::uint8_t>;

bool begins_with(Bytes bytes, std::string_view name) {
  return bytes.size() >= name.size() && std::ranges::equal(bytes.first(name.size()), name);
}

WavFormat format_of(Bytes chunk) {
  WavFormat format{.kind = read_u16(&chunk[0]),
                   .channels = read_u16(&chunk[2]),
                   .bits = read_u16(&chunk[14]),
                   .rate_hz = read_u32(&chunk[4])};
  constexpr std::size_t kSubFormat = 24;
  if (format.kind == kExtensible && chunk.size() >= kSubFormat + 2)
    format.kind = read_u16(&chunk[kSubFormat]);
  return format;
}

Status check(const WavFormat& format) {
  const auto [kind, channels, bits, rate_hz] = format;
  const bool is_pcm = kind == kPcm && (bits == 8 || bits == 16 || bits == 24 || bits == 32);
  if (!is_pcm && !(kind == kFloat && bits == 32)) {
    return Error{ErrorCode::kUnsupported,
                 "is a WAV file of another kind than PCM of 8 to 32 bits; convert it, for example "
                 "with ffmpeg -i FILE -c:a pcm_s16le NEW.wav"};
  }
  if (channels < 1 || channels > kMaxChannels)
    return Error{ErrorCode::kUnsupported, "has more than 8 channels, or none"};
  if (rate_hz < 8'000 || rate_hz > 192'000)
    return Error{ErrorCode::kUnsupported, "has a sample rate outside 8 to 192 kHz"};
  return {};
}

float sample_at(const std::uint8_t* at, const WavFormat& format) {
  switch (format.bits) {
    case 8:
      return static_cast<float>(*at - 128) / 128;
    case 16:
      return static_cast<float>(static_cast<std::int16_t>(read_u16(at))) / 32768;
    case 24: {
      const std::uint32_t high = static_cast<std::uint32_t>(read_u16(at + 1)) << 16U;
      return static_cast<float>(static_cast<std::int32_t>(high | (std::uint32_t{*at} << 8U))) /
             2147483648.F;
    }
    default:
      break;
  }
  if (format.kind == kPcm)
    return static_cast<float>(static_cast<std::int32_t>(read_u32(at))) / 2147483648.F;
  const auto value = std::bit_cast<float>(read_u32(at));
  return std::isfinite(value) ? std::clamp(value, -1.F, 1.F) : 0.F;
}

WavSound sound_of(const WavFormat& format, Bytes data) {
  WavSound sound{
      .rate_hz = static_cast<int>(format.rate_hz), .channels = format.channels, .samples = {}};
  const std::size_t width = format.bits / 8U;
  const std::size_t instants = data.size() / (width * format.channels);
  sound.samples.resize(instants * format.channels);
  for (std::size_t i = 0; i < sound.samples.size(); ++i)
    sound.samples[i] = sample_at(&data[i * width], format);
  return sound;
}

}  // namespace

Result<WavSound> parse_wav(Bytes file) {
  constexpr std::size_t kRiffHeader = 12, kChunkHeader = 8, kFormatBytes = 16;
  if (!begins_with(file, "RIFF") || file.size() < kRiffHeader ||
      !begins_with(file.subspan(8), "WAVE"))
    return malformed("is no WAV file");
  std::optional<WavFormat> format;
  for (Bytes rest = file.subspan(kRiffHeader); rest.size() >= kChunkHeader;) {
    const std::size_t length = read_u32(&rest[4]);
    const Bytes chunk = rest.subspan(kChunkHeader, std::min(length, rest.size() - kChunkHeader));
    if (begins_with(rest, "fmt ")) {
      if (chunk.size() < kFormatBytes) break;
      format = format_of(chunk);
      if (auto status = check(*format); !status) return status.error();
    } else if (begins_with(rest, "data")) {
      if (!format) break;
      WavSound sound = sound_of(*format, chunk);  // a file that is cut off has what is there
      if (sound.samples.empty()) return malformed("is a WAV file without sound");
      return sound;
    }
    const std::size_t step = kChunkHeader + length + length % 2;
    rest = rest.subspan(std::min(step, rest.size()));
  }
  return malformed("is a damaged WAV file: it has no sound");
}

Result<WavSound> read_wav(const std::filesystem::path& path) {
  std::vector<std::uint8_t> bytes;
  if (auto status = io::read_file(path, kMaxWavBytes, bytes); !status) return status.error();
  auto sound = parse_wav(bytes);
  if (!sound) return Error{sound.error().code, path.string() + " " + sound.error().message};
  return sound;
}

std::vector<float> one_channel(const WavSound& sound) {
  const auto channels = static_cast<std::size_t>(sound.channels);
  std::vector<float> mean(sound.samples.size() / channels);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    for (std::size_t channel = 0; channel < channels; ++channel)
      mean[i] += sound.samples[i * channels + channel] / static_cast<float>(channels);
  }
  return resampled(std::move(mean), sound.rate_hz, voice::kVoiceRate_hz);
}

}  // namespace roomcast::sound
