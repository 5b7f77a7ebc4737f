// SPDX-License-Identifier: Apache-2.0
// Requests of a viewer to its hub, each with its answer: to leave and remove marks, and to propose
// where a sensor is. Metres. The hub answers by what it then tells everybody, so one thread at a
// time may ask through a subscriber. Threading: blocks.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>

#include "roomcast/client/room/room_mark.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"

namespace roomcast::client {

/// How long to wait for an answer.
struct Patience {
  std::chrono::milliseconds time;
  std::stop_token stop = {};  // ends the wait soon
};
inline const Patience kMarkPatience{std::chrono::seconds(5)};
inline const Patience kPriorPatience{std::chrono::seconds(20)};

/// Leaves a mark, of which kind, points and text count; returns its ID. kMalformed, kTooLarge: no
/// hub takes this mark. kUnavailable: the hub refuses it, with the reason, or there is no
/// connection, or no answer came.
[[nodiscard]] Result<std::uint32_t> leave_mark(Subscriber& room, const RoomMark& mark,
                                               const Patience& patience = kMarkPatience);

/// kNotFound: there is no such mark. Else as above.
[[nodiscard]] Status remove_mark(Subscriber& room, std::uint32_t mark,
                                 const Patience& patience = kMarkPatience);

struct PlacedSensor {
  RigidTransform world_from_depth;
  double expected_error_mm = 0;  // 2.5 m ahead of it
};

/// Proposes a pose for a sensor, made of its present one; the room's aligner refines it and accepts
/// or refuses it. Returns the sensor's new pose. kUnavailable: this viewer may not, the sensor has
/// supplied its own pose, the aligner refuses, with the reason, or no answer came, or there is no
/// connection. kNotFound: there is no such sensor.
[[nodiscard]] Result<PlacedSensor> place_sensor(
    Subscriber& room, const std::string& sensor,
    const std::function<RigidTransform(const RigidTransform& world_from_depth)>& wanted,
    const Patience& patience = kPriorPatience);

}  // namespace roomcast::client
