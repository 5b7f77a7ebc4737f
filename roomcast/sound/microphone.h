// SPDX-License-Identifier: Apache-2.0
// Microphone: where sound comes from, 20 ms at a time: one channel at voice::kVoiceRate_hz.
// Single-threaded.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>

#include "roomcast/core/clock.h"
#include "roomcast/core/result.h"
#include "roomcast/voice/voice_decoder.h"

namespace roomcast::sound {

class Microphone {
 public:
  struct Block {
    std::array<float, voice::kPacketSamples> samples{};  // -1 to 1
    HostTime first_sample{};
  };

  virtual ~Microphone() = default;
  /// Waits for the next one. Nothing: there will be none any more, or `stop` was requested.
  /// kUnavailable: the device is gone.
  [[nodiscard]] virtual Result<std::optional<Block>> next(const std::stop_token& stop) = 0;
};

using OpenMicrophone = std::function<Result<std::unique_ptr<Microphone>>()>;

/// Root of the mean square.
[[nodiscard]] double loudness_of(const Microphone::Block& block);

}  // namespace roomcast::sound
