// SPDX-License-Identifier: Apache-2.0
// RoomSettings: the owner's settings of a room: capacity, start positions and permissions. The
// admin interface transfers them as JSON (docs/spec/admin.openapi.yaml). Plain data. Metres,
// radians.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "roomcast/core/result.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

/// The clients that have a permission in a room.
enum class AccessRule {
  kAnyone,
  kToken,  // with a token of the right role
  kAdmin,  // with an admin's token
  kNobody,
};

[[nodiscard]] std::string_view name_of(AccessRule rule);
[[nodiscard]] std::optional<AccessRule> access_rule_named(std::string_view name);

/// The position and direction in which a viewer starts.
struct StartPosition {
  double x_m = 0, z_m = 0;
  double eye_height_m = 1.6;
  double yaw_rad = 0;  // 0 looks along -z; counter-clockwise from above
};

/// world_from_viewer, viewer frame x right, y up, -z forward.
[[nodiscard]] RigidTransform world_from_viewer(const StartPosition& position);

/// Of a room whose owner sets none. Earlier viewers take no more in a roster.
inline constexpr std::size_t kUsualMaxViewers = 512;

struct RoomSettings {
  std::string name = "room";
  std::string title = {};  // shown to people; empty: the name
  std::size_t max_sensors = wire::kMaxSensors;
  std::size_t max_viewers = kUsualMaxViewers;
  bool listed = true;  // false: known only to clients with a token for it
  AccessRule send = AccessRule::kAnyone;
  AccessRule view = AccessRule::kAnyone;
  AccessRule record = AccessRule::kAnyone;
  AccessRule share = AccessRule::kAnyone;  // "export" in JSON
  AccessRule speak = AccessRule::kAnyone;  // of those who may view
  AccessRule mark = AccessRule::kAnyone;   // leave marks
  bool record_voices = true;               // recorders get people's voices, too
  double uplink_mbit = 0;  // that the sensors share, Mbit/s; 0: they send as they were started
  bool stream_unwatched = false;                    // sensors send frames while nobody watches, too
  std::vector<StartPosition> start_positions = {};  // used in turn; none: next to the sensors
  std::vector<std::string> embed_from = {};         // web sites whose pages may show this room
};

inline constexpr double kMinUplink_mbit = 0.1, kMaxUplink_mbit = 1000;
inline constexpr std::size_t kMaxStartPositions = 64;
inline constexpr std::size_t kMaxEmbedSites = 16;

/// kInvalidArgument: a limit is exceeded, or a name is invalid.
[[nodiscard]] Status check(const RoomSettings& settings);

[[nodiscard]] nlohmann::json to_json(const RoomSettings& settings);

/// Returns `settings` with the fields of `changes` replaced. kInvalidArgument: an unknown field or
/// an invalid value; the sentence names it.
[[nodiscard]] Result<RoomSettings> changed(RoomSettings settings, const nlohmann::json& changes);

}  // namespace roomcast::hub
