// SPDX-License-Identifier: Apache-2.0
// VoiceMix: sums pieces of sound that come nearly in order of time, and gives them back in order,
// in blocks of 20 ms. Memory: what lies between the oldest piece that may still come and the
// newest; silence takes none. Time: samples at 48 kHz; before 0 there is nothing. Single-threaded.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <vector>

#include "roomcast/sound/listener_gains.h"
#include "roomcast/voice/voice_decoder.h"

namespace roomcast::recording {

using sound::Gains;

class VoiceMix {
 public:
  struct Out {
    std::function<void(std::span<const float>)> sound;  // of all channels in turn
    std::function<void(std::int64_t samples)> silence;  // likewise
  };

  VoiceMix(int channels, Out out) : channels_(channels), out_(std::move(out)) {}

  /// What lies before the time up to which all was given back is left out.
  void add(std::int64_t at, std::span<const float> samples, const Gains& gains);
  /// Gives back what lies before `until`, in whole blocks.
  void give_until(std::int64_t until);
  /// Gives back all up to `end`, exactly.
  void finish(std::int64_t end);

 private:
  std::vector<float>& block(std::int64_t number);

  const int channels_;
  const Out out_;
  std::map<std::int64_t, std::vector<float>> blocks_;
  std::int64_t next_block_ = 0;
};

}  // namespace roomcast::recording
