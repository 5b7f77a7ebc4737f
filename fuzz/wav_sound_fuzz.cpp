// SPDX-License-Identifier: Apache-2.0
// Reads an untrusted WAV file: any bytes are refused or read, and give no more samples than bytes.
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "roomcast/sound/wav_sound.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto sound = roomcast::sound::parse_wav({data, size});
  if (!sound) return 0;
  if (sound->samples.size() > size) __builtin_trap();
  for (const float sample : sound->samples)
    if (!(std::abs(sample) <= 1)) __builtin_trap();
  return 0;
}
