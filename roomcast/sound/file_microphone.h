// SPDX-License-Identifier: Apache-2.0
// FileMicrophone: a WAV file in the place of a microphone, in real time, once or again and again.
// Single-threaded.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "roomcast/sound/microphone.h"

namespace roomcast::sound {

class FileMicrophone final : public Microphone {
 public:
  /// The longest file: it is kept in memory.
  static constexpr std::chrono::minutes kMaxLength{20};

  /// Errors of read_wav; kTooLarge: longer than kMaxLength.
  static Result<std::unique_ptr<Microphone>> open(const std::filesystem::path& path, bool loops);

  FileMicrophone(std::vector<float> samples, bool loops, HostTime begins)
      : samples_(std::move(samples)), loops_(loops), next_(begins) {}

  Result<std::optional<Block>> next(const std::stop_token& stop) override;

 private:
  const std::vector<float> samples_;
  const bool loops_;
  HostTime next_;  // when the next block begins
  std::size_t at_ = 0;
};

}  // namespace roomcast::sound
