// SPDX-License-Identifier: Apache-2.0
// A speaker in a room, and the place of the sound: a person, or a sensor's microphone
// (docs/spec/wire.md section 6). No state.
#pragma once

#include <optional>
#include <string>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/core/ids.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::client {

/// The sensor whose microphone this is; nothing: a person.
[[nodiscard]] std::optional<SensorId> sensor_of_speaker(ViewerId speaker);

/// x right, y up, -z ahead of the person's head or the sensor; nothing: not known.
[[nodiscard]] std::optional<RigidTransform> world_from_speaker(const RoomSnapshot& room,
                                                               ViewerId speaker);

/// Whether it is in the room.
[[nodiscard]] bool speaker_is_here(const RoomSnapshot& room, ViewerId speaker);

/// Empty: nobody of this ID is known, or the person gave no name.
[[nodiscard]] std::string speaker_name(const RoomSnapshot& room, ViewerId speaker);

}  // namespace roomcast::client
