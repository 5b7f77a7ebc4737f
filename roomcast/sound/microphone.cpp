// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sound/microphone.h"

#include <cmath>

namespace roomcast::sound {

double loudness_of(const Microphone::Block& block) {
  double sum = 0;
  for (const float sample : block.samples) sum += static_cast<double>(sample) * sample;
  return std::sqrt(sum / static_cast<double>(block.samples.size()));
}

}  // namespace roomcast::sound
