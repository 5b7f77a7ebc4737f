// SPDX-License-Identifier: Apache-2.0
// Loudspeaker: where sound goes to, 20 ms at a time: left and right in turn at
// voice::kVoiceRate_hz. Single-threaded.
#pragma once

#include <array>
#include <span>
#include <stop_token>

#include "roomcast/core/result.h"
#include "roomcast/voice/voice_decoder.h"

namespace roomcast::sound {

using StereoBlock = std::array<float, 2 * voice::kPacketSamples>;

class Loudspeaker {
 public:
  virtual ~Loudspeaker() = default;
  /// Waits until there is room for the block, -1 to 1, and plays it after those before it. False:
  /// `stop` was requested. kUnavailable: the device is gone, or the disk is full.
  [[nodiscard]] virtual Result<bool> play(const StereoBlock& block,
                                          const std::stop_token& stop) = 0;
};

}  // namespace roomcast::sound
