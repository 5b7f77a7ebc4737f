// SPDX-License-Identifier: Apache-2.0
// The NATS subjects used between hubs. They let a broker permit a hub only certain rooms:
// "roomcast.room.lab.>". Source: NATS subject naming, docs.nats.io/nats-concepts/subjects.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "roomcast/hub/federation/cluster/hub_id.h"

namespace roomcast::hub::federation {

inline constexpr char kHeartbeatSubject[] = "roomcast.hubs";
inline constexpr char kRevokedSubject[] = "roomcast.revoked";

/// To one hub alone.
[[nodiscard]] std::string inbox_subject(HubId hub);
[[nodiscard]] std::string news_subject(std::string_view room);
/// Frames of the sensors connected to hub `from`.
[[nodiscard]] std::string frames_subject(std::string_view room, HubId from);
/// Frames of the sensors connected to any hub.
[[nodiscard]] std::string all_frames_subject(std::string_view room);

/// Poses of the room's people at any hub.
[[nodiscard]] std::string poses_subject(std::string_view room);

enum class Subject { kHeartbeat, kRevoked, kInbox, kNews, kPoses, kFrames };
struct ReadSubject {
  Subject subject;
  std::string room = {};  // of kNews, kPoses and kFrames
  HubId hub = {};         // of kFrames
};
/// Nothing: not a subject of ours.
[[nodiscard]] std::optional<ReadSubject> read_subject(std::string_view subject);

}  // namespace roomcast::hub::federation
