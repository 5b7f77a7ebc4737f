// SPDX-License-Identifier: Apache-2.0
// Adds a sound file to a film, by ffmpeg; pictures are not encoded again. Threading: no state.
#pragma once

#include <filesystem>

#include "roomcast/core/result.h"

namespace roomcast::recording {

/// Replaces `film`, once the one with sound is complete. kUnavailable: ffmpeg does not start or
/// fails; the film stays as it is.
[[nodiscard]] Status add_sound(const std::filesystem::path& film,
                               const std::filesystem::path& sound);

}  // namespace roomcast::recording
