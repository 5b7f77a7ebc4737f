// SPDX-License-Identifier: Apache-2.0
// WavFile: a sound file of 16-bit PCM at 48 kHz (RIFF WAVE, Microsoft and IBM 1991). Loud passages
// are bent instead of cut off. Silence takes no space on disks that can leave it out. The file has
// its final name when it is complete. Single-threaded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

#include "roomcast/core/result.h"

namespace roomcast::sound {

class WavFile {
 public:
  /// Of one channel; of two, half of it.
  static constexpr std::int64_t kMaxSamples = 0x7FFFF000;

  /// kTooLarge, for sound beyond kMaxSamples.
  [[nodiscard]] static Error too_long();

  /// kUnavailable if the file exists already or cannot be written.
  static Result<WavFile> create(const std::filesystem::path& path, int channels);
  WavFile(WavFile&&) = default;
  WavFile& operator=(WavFile&&) = default;
  /// Removes a file that was not finished.
  ~WavFile();

  /// Samples of all channels in turn, -1 to 1.
  void append(std::span<const float> samples);
  void append_silence(std::int64_t samples);
  /// kUnavailable if the disk is full; kTooLarge beyond kMaxSamples.
  [[nodiscard]] Status finish();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  WavFile(std::filesystem::path path, std::filesystem::path part, int channels);
  void write_header();

  std::filesystem::path path_, part_;
  int channels_;
  std::int64_t samples_ = 0;
  std::ofstream file_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace roomcast::sound
