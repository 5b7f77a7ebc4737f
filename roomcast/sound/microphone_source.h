// SPDX-License-Identifier: Apache-2.0
// Opens what a person names as a microphone: a sound card's input, or a WAV file in its place.
#pragma once

#include <string>
#include <vector>

#include "roomcast/sound/microphone.h"

namespace roomcast::sound {

inline constexpr const char* kMicrophoneSources =
    "default, alsa:DEVICE (arecord -L lists them), or wav:FILE";

/// "default", "alsa:DEVICE", "wav:FILE", "FILE.wav". `loops`: begin a file again at its end.
/// kInvalidArgument: it is none of these. kUnsupported: this program was built without ALSA. Else
/// the errors of FileMicrophone and AlsaMicrophone.
[[nodiscard]] Result<std::unique_ptr<Microphone>> open_microphone(const std::string& source,
                                                                  bool loops);

/// From now on libasound, also where another library uses it, writes no complaints to the terminal.
void keep_alsa_quiet();

struct KnownMicrophone {
  std::string source;       // for open_microphone
  std::string description;  // of its sound card
};

/// The inputs of this computer's sound cards. Servers (PipeWire, PulseAudio) have "default".
[[nodiscard]] std::vector<KnownMicrophone> known_microphones();

}  // namespace roomcast::sound
