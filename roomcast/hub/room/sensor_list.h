// SPDX-License-Identifier: Apache-2.0
// SensorList: the sensors that a room has seen, by name, ID and connection. A name keeps its ID,
// also across a restart of the hub if remember() is called. An offline sensor without an estimated
// pose loses its ID if new sensors need it. Single-threaded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <ranges>
#include <string>
#include <unordered_map>
#include <vector>

#include "roomcast/core/ids.h"
#include "roomcast/geometry/sensor_pose.h"
#include "roomcast/hub/room/gone_surfaces.h"
#include "roomcast/hub/room/key_request_pace.h"
#include "roomcast/hub/room/known_sensor.h"
#include "roomcast/hub/room/room_stats.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

/// The sensor ID in a message. A number that is too large becomes wire::kMaxSensors, which no
/// sensor has.
[[nodiscard]] SensorId wire_id(std::uint32_t id);

struct RoomSensor {
  SensorId id;
  std::string name;
  std::optional<ConnectionId> connection = {};  // while online
  wire::pb::SensorRole description = {};        // from its newest Join
  SensorPose pose = {};
  std::uint32_t valid_from_bundle = 0;                // ignore poses estimated from earlier bundles
  std::optional<wire::pb::Control> bundle = {};       // the newest one since it joined
  std::uint32_t bundles = 0;                          // number of bundles that it has ever sent
  std::size_t bundle_hash = 0;                        // of the newest bundle
  std::optional<std::size_t> verified_by = {};        // hash of the bundle its pose is from
  std::string token_id = {};                          // of the token that it joined with
  bool may_speak = false;                             // its microphone may be heard
  bool has_spoken = false;                            // since it joined
  bool is_at_other_hub = false;                       // it is connected to another hub
  std::uint64_t left_as = 0;                          // counts the departures of all sensors
  std::optional<wire::pb::SensorHealth> health = {};  // the newest of this connection
  std::optional<wire::pb::CoarseDepth> coarse_depth = {};  // likewise
  std::optional<RigidTransform> surface_pose = {};         // where coarse_depth was placed by it
  double told_depth_scale = 1;                             // on this connection
  wire::pb::FrameDemand wanted = {};                       // what it should be told
  wire::pb::FrameDemand told = {};                         // on this connection
  KeyRequestPace key_pace = {};
  KeyRequestPace small_key_pace = {};  // of its small rendition
  GoneSurfaces gone = {};
  SensorStats stats = {};  // the counters that change with its frames
};

class SensorList {
 public:
  /// The sensors known before the hub was started. Must be called before all other members.
  void remember(std::vector<KnownSensor> sensors) { remembered_ = std::move(sensors); }

  /// The remembered sensor of this name; null: none.
  [[nodiscard]] const KnownSensor* remembered(const std::string& name) const;

  /// Adds a sensor with a new name. It gets the ID remembered for its name if that is free, else
  /// the lowest ID that is neither used nor remembered, else a remembered one. Null: all
  /// wire::kMaxSensors IDs are in use.
  RoomSensor* add(const std::string& name);
  /// Whether add() would take the ID of another remembered sensor that had a pose.
  [[nodiscard]] bool would_displace(const std::string& name) const;

  /// The sensor that has been offline longest, among those without an estimated pose. Null: none.
  [[nodiscard]] RoomSensor* longest_gone();
  /// Removes a sensor, which must be offline.
  void remove(const RoomSensor& sensor);
  /// As remove(), and drops the remembered data of this name. False: the name was unknown.
  bool forget(const std::string& name);

  /// Null: no sensor has this name, ID or connection.
  [[nodiscard]] RoomSensor* find(const std::string& name);
  [[nodiscard]] RoomSensor* find(SensorId id);
  [[nodiscard]] RoomSensor* find(ConnectionId connection);

  /// Marks the sensor as online on this connection only.
  void connect(RoomSensor& sensor, ConnectionId connection);
  void disconnect(RoomSensor& sensor);

  [[nodiscard]] std::size_t count() const { return sensors_.size(); }
  [[nodiscard]] std::size_t online_count() const { return by_connection_.size(); }
  /// In the order of the IDs.
  [[nodiscard]] auto all() { return std::views::values(sensors_); }
  [[nodiscard]] auto all() const { return std::views::values(sensors_); }

 private:
  [[nodiscard]] std::optional<SensorId> free_id(const std::string& name) const;
  [[nodiscard]] const KnownSensor* remembered(SensorId id) const;

  std::map<SensorId, RoomSensor> sensors_;
  std::unordered_map<ConnectionId, SensorId> by_connection_;
  std::vector<KnownSensor> remembered_;
  std::uint64_t departures_ = 0;
  /// The highest number; poses estimated from bundles up to it are outdated.
  std::uint32_t max_removed_bundle_ = 0;
};

}  // namespace roomcast::hub
