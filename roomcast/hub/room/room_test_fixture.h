// SPDX-License-Identifier: Apache-2.0
// For tests of the Room: lets clients join it and sorts the actions that it returns.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/hub/room/room.h"
#include "roomcast/wire/pose_message.h"

namespace roomcast::hub {

using namespace std::chrono_literals;
namespace pb = wire::pb;

inline RoomTime at(nanoseconds since_start) {
  return RoomTime(1h + since_start);
}

inline RigidTransform pose_at(double x) {
  return {Eigen::Matrix3d::Identity(), {x, 0, 0}};
}

/// The pose at (x, 0, 0) as a store returns it.
inline SensorPose stored_pose_at(double x, double expected_error_mm) {
  return {pose_at(x), PoseSource::kStored, PoseState::kUnverified, expected_error_mm, ""};
}

inline pb::Join sensor_join(const std::string& name,
                            std::optional<RigidTransform> world_from_depth = pose_at(1)) {
  pb::Join join;
  join.set_name(name);
  join.mutable_sensor()->set_fps(30);
  join.mutable_sensor()->mutable_calibration()->mutable_depth()->set_width(512);
  if (world_from_depth) {
    wire::write_transform(*world_from_depth, *join.mutable_sensor()->mutable_world_from_depth());
  }
  return join;
}

inline pb::Join viewer_join(const std::string& name = "") {
  pb::Join join;
  join.set_name(name);
  join.mutable_viewer();
  return join;
}

inline pb::Join aligner_join() {
  pb::Join join;
  join.mutable_aligner();
  return join;
}

inline pb::Join modeler_join() {
  pb::Join join;
  join.mutable_modeler();
  return join;
}

/// A placement of the sensor with this ID at (x, 0, 0), x in metres.
inline pb::Control placement_of(std::uint32_t sensor, double x) {
  pb::Control control;
  auto& found = *control.mutable_placements()->add_sensors();
  found.set_sensor_id(sensor);
  wire::write_transform(pose_at(x), *found.mutable_world_from_depth());
  found.set_expected_error_mm(4);
  return control;
}

/// A placement of sensor 0 that was estimated from bundle `number`.
inline pb::Control placement_from_bundle(std::uint32_t number, double x) {
  pb::Control control = placement_of(0, x);
  control.mutable_placements()->mutable_sensors(0)->set_bundle_number(number);
  return control;
}

template <class T>
std::vector<T> all(const RoomActions& actions) {
  std::vector<T> found;
  for (const auto& action : actions) {
    if (const auto* match = std::get_if<T>(&action)) found.push_back(*match);
  }
  return found;
}

/// The control messages of one kind, with their receivers.
inline std::vector<SendControl> messages(const RoomActions& actions,
                                         pb::Control::MessageCase kind) {
  auto found = all<SendControl>(actions);
  std::erase_if(found,
                [&](const SendControl& send) { return send.message.message_case() != kind; });
  return found;
}

inline pb::Roster newest_roster(const RoomActions& actions) {
  const auto rosters = messages(actions, pb::Control::kRoster);
  return rosters.empty() ? pb::Roster() : rosters.back().message.roster();
}

class RoomTest : public testing::Test {
 protected:
  ConnectionId enter(const pb::Join& join, nanoseconds now = 0s, const Entry& entry = {}) {
    const ConnectionId connection{next_connection++};
    actions = room.join(connection, join, entry, at(now));
    return connection;
  }

  static IncomingFrame incoming(ConnectionId from, SensorId sensor, nanoseconds captured,
                                bool key = true) {
    wire::FrameHeader header{.key = key, .sensor = sensor, .capture_time = at(captured)};
    std::vector<std::uint8_t> bytes(wire::kFrameHeaderBytes);
    wire::write_frame_header(header, std::span(bytes).first<wire::kFrameHeaderBytes>());
    return {from, header, net::MessageBuffer(bytes)};
  }

  RoomActions frame(ConnectionId from, SensorId sensor, nanoseconds captured, nanoseconds arrived,
                    bool key = true) {
    auto [who, header, message] = incoming(from, sensor, captured, key);
    return room.frame(who, header, std::move(message), at(arrived));
  }

  Room room{RoomSettings{.name = "lab"}, "test"};
  RoomActions actions;  // returned by the last enter()
  std::uint64_t next_connection = 1;
};

}  // namespace roomcast::hub
