// SPDX-License-Identifier: Apache-2.0
// The NATS subjects on which hubs talk. A broker can allow a hub single rooms by them:
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
/// Frames of what sends to this hub.
[[nodiscard]] std::string frames_subject(std::string_view room, HubId from);
/// Of what sends to any hub.
[[nodiscard]] std::string all_frames_subject(std::string_view room);

/// Where people are who watch the room at any hub.
[[nodiscard]] std::string poses_subject(std::string_view room);

enum class Subject { kHeartbeat, kRevoked, kInbox, kNews, kPoses, kFrames };
struct ReadSubject {
  Subject subject;
  std::string room = {};  // of kNews, kPoses and kFrames
  HubId hub = {};         // of kFrames
};
/// Nothing: not one of ours.
[[nodiscard]] std::optional<ReadSubject> read_subject(std::string_view subject);

}  // namespace roomcast::hub::federation
