// SPDX-License-Identifier: Apache-2.0
// RoomSettings: what its owner decides about a room: how many it holds, where viewers enter, and
// who may do what in it. As JSON it is what the admin interface speaks
// (docs/spec/admin.openapi.yaml). Plain data. Metres, radians.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "roomcast/core/result.h"
#include "roomcast/hub/config/matrix4.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

/// Who may do something in a room.
enum class Who {
  kAnyone,
  kToken,  // with a token of the right role
  kAdmin,  // with an admin's token
  kNobody,
};

[[nodiscard]] std::string_view name_of(Who who);
[[nodiscard]] std::optional<Who> who_is(std::string_view name);

/// Where a viewer enters.
struct StartPosition {
  double x_m = 0, z_m = 0;
  double eye_height_m = 1.6;
  double yaw_rad = 0;  // 0 looks along -z; counter-clockwise from above
};

/// world_from_viewer, viewer frame x right, y up, -z forward.
[[nodiscard]] Matrix4 world_from_viewer(const StartPosition& position);

struct RoomSettings {
  std::string name = "room";
  std::string title = {};  // for people; empty: the name
  std::size_t max_sensors = wire::kMaxSensors;
  std::size_t max_viewers = wire::kMaxViewers;
  bool listed = true;  // else nobody without a token for it learns that it exists
  Who send = Who::kAnyone;
  Who view = Who::kAnyone;
  Who record = Who::kAnyone;
  Who share = Who::kAnyone;                         // "export" in JSON
  std::vector<StartPosition> start_positions = {};  // in turn; none: beside the sensors
};

inline constexpr std::size_t kMaxStartPositions = 64;

/// kInvalidArgument: a limit is exceeded, or a name cannot be one.
[[nodiscard]] Status check(const RoomSettings& settings);

[[nodiscard]] nlohmann::json to_json(const RoomSettings& settings);

/// `settings` with what `changes` says instead. kInvalidArgument: a field that there is not, or a
/// value that makes no sense there; the sentence names it.
[[nodiscard]] Result<RoomSettings> changed(RoomSettings settings, const nlohmann::json& changes);

}  // namespace roomcast::hub
