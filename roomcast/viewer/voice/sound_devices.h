// SPDX-License-Identifier: Apache-2.0
// Microphones and loudspeakers through SDL's audio (PipeWire, PulseAudio, ALSA), or WAV files in
// their place. Thread-safe (no state).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "roomcast/sound/loudspeaker.h"
#include "roomcast/sound/microphone.h"

namespace roomcast::viewer {

/// `device`: "default", the name of a device, or a file that ends in .wav, which is played again
/// and again. kNotFound, kUnavailable, and the errors of FileMicrophone.
[[nodiscard]] Result<std::unique_ptr<sound::Microphone>> open_microphone(const std::string& device);

/// Likewise; a file must not exist yet. Null for "none".
[[nodiscard]] Result<std::unique_ptr<sound::Loudspeaker>> open_loudspeaker(
    const std::string& device);

enum class SoundDirection { kIn, kOut };

/// Names of the devices that there are now.
[[nodiscard]] std::vector<std::string> sound_devices(SoundDirection direction);

}  // namespace roomcast::viewer
