// SPDX-License-Identifier: Apache-2.0
// The panel's part for voice: microphone, loudspeaker, who is how loud. Draws with Dear ImGui,
// inside of a window.
#pragma once

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/viewer/voice/voice_settings.h"

namespace roomcast::viewer {

/// 0 to 1 for a meter: decibels, as ears hear; `loudness` as in VoiceFacts.
[[nodiscard]] float meter_of(double loudness);

/// Changes `settings` by the user's input.
void draw_voice_controls(const VoiceFacts& facts, const client::RoomSnapshot& room,
                         VoiceSettings& settings);

}  // namespace roomcast::viewer
