// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/wav_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "roomcast/core/little_endian.h"
#include "roomcast/voice/voice_decoder.h"

namespace roomcast::sound {
namespace {

constexpr std::size_t kWavHeaderBytes = 44;
constexpr std::int64_t kBytesPerSample = 2;
constexpr float kStraightUntil = 0.8F;

/// As it is up to 0.8; what is louder approaches 1.
float bent(float value) {
  const float loudness = std::abs(value);
  if (loudness <= kStraightUntil) return value;
  constexpr float kRest = 1 - kStraightUntil;
  return std::copysign(kStraightUntil + kRest * std::tanh((loudness - kStraightUntil) / kRest),
                       value);
}

Error not_written(const std::filesystem::path& path) {
  return {ErrorCode::kUnavailable, "cannot write " + path.string() + ": is the disk full?"};
}

}  // namespace

Result<WavFile> WavFile::create(const std::filesystem::path& path, int channels) {
  std::error_code ignored;
  if (std::filesystem::exists(path, ignored)) {
    return Error{ErrorCode::kUnavailable,
                 "there is " + path.string() + " already; choose another folder"};
  }
  std::filesystem::path part = path;
  part += ".part";
  WavFile file(path, part, channels);
  if (!file.file_) return not_written(path);
  return file;
}

Error WavFile::too_long() {
  return {ErrorCode::kTooLarge,
          "a WAV file holds 12 hours of one channel and 6 hours of two; choose a part with --from "
          "and --to"};
}

WavFile::WavFile(std::filesystem::path path, std::filesystem::path part, int channels)
    : path_(std::move(path)),
      part_(std::move(part)),
      channels_(channels),
      file_(part_, std::ios::binary | std::ios::trunc) {
  write_header();
}

WavFile::~WavFile() {
  if (!file_.is_open()) return;
  file_.close();
  std::error_code ignored;
  std::filesystem::remove(part_, ignored);
}

void WavFile::append(std::span<const float> samples) {
  bytes_.resize(2 * samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto value = static_cast<std::int16_t>(std::lround(32767 * bent(samples[i])));
    write_u16(&bytes_[2 * i], static_cast<std::uint16_t>(value));
  }
  file_.write(reinterpret_cast<const char*>(bytes_.data()),
              static_cast<std::streamsize>(bytes_.size()));
  samples_ += static_cast<std::int64_t>(samples.size());
}

void WavFile::append_silence(std::int64_t samples) {
  if (samples <= 0) return;
  samples_ += samples;
  // A hole, which ends with a byte that is written.
  file_.seekp(kWavHeaderBytes + kBytesPerSample * samples_ - 1);
  file_.put(0);
}

void WavFile::write_header() {
  std::array<std::uint8_t, kWavHeaderBytes> header{};
  const auto data_bytes = static_cast<std::uint32_t>(kBytesPerSample * samples_);
  const auto bytes_per_instant = static_cast<std::uint16_t>(kBytesPerSample * channels_);
  std::memcpy(header.data(), "RIFF", 4);
  write_u32(&header[4], data_bytes + 36);
  std::memcpy(&header[8], "WAVEfmt ", 8);
  write_u32(&header[16], 16);
  write_u16(&header[20], 1);  // PCM
  write_u16(&header[22], static_cast<std::uint16_t>(channels_));
  write_u32(&header[24], voice::kVoiceRate_hz);
  write_u32(&header[28], static_cast<std::uint32_t>(voice::kVoiceRate_hz) * bytes_per_instant);
  write_u16(&header[32], bytes_per_instant);
  write_u16(&header[34], 8 * kBytesPerSample);
  std::memcpy(&header[36], "data", 4);
  write_u32(&header[40], data_bytes);
  file_.seekp(0);
  file_.write(reinterpret_cast<const char*>(header.data()), header.size());
}

Status WavFile::finish() {
  if (samples_ > kMaxSamples) return too_long();
  write_header();
  file_.close();
  if (!file_) return not_written(path_);
  std::error_code error;
  std::filesystem::rename(part_, path_, error);
  return error ? Status(not_written(path_)) : Status();
}

}  // namespace roomcast::sound
