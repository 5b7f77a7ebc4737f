// SPDX-License-Identifier: Apache-2.0
// Says a program's samples in its room. Thread-safe if one thread at a time uses a voice.
#pragma once

#include <span>

#include "roomcast/client/subscriber.h"
#include "roomcast/client/voices/spoken_voice.h"
#include "roomcast/core/result.h"

namespace roomcast::client {

/// `samples` were recorded just before `now`. kUnavailable: the room does not let this viewer
/// speak. Else the errors of SpokenVoice::say. Without a connection nobody hears it.
[[nodiscard]] Status speak(Subscriber& room, SpokenVoice& voice, std::span<const float> samples,
                           HostTime now);

/// Says what is left over, and that a pause follows.
void pause_speaking(Subscriber& room, SpokenVoice& voice);

}  // namespace roomcast::client
