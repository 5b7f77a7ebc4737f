// SPDX-License-Identifier: Apache-2.0
// RoomSnapshot: all data for drawing a room at one moment. Threading: immutable once shared.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/client/room/clock_estimate.h"
#include "roomcast/client/room/person_pose.h"
#include "roomcast/client/room/room_mark.h"
#include "roomcast/client/room/viewer_rights.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/geometry/sensor_pose.h"

namespace roomcast::client {

/// A sensor's newest picture. An unchanged picture is the same object in later snapshots.
struct SensorPicture {
  std::uint32_t seq = 0;
  SetId set{};
  RoomTime capture_time{};
  HostTime received{}, decoded{};
  codec::DecodedFrame frame;
};

struct RoomSensor {
  SensorId id{};
  std::string name;
  bool online = false;
  SensorPose pose;
  double fps = 0;
  SensorCalibration calibration;
  std::shared_ptr<const SensorPicture> picture;  // null before its first frame
  /// The hub sends no frames, or had sent none before and the first one is still to come, because
  /// this viewer cannot see what the sensor shows. The picture is old.
  bool is_paused = false;
  bool is_small = false;  // the picture is of its small rendition: this viewer's line takes no more
  /// This viewer's line does not take even all small renditions: only key frames of this one come.
  bool is_held_back = false;
  bool speaking = false;  // its microphone is heard; these two are known to viewers that hear
  bool muted = false;     // its microphone, by an admin
  std::uint64_t frames_received = 0;
  std::uint64_t frames_missed = 0;  // skipped on their way, or not decodable
  std::uint64_t bytes_received = 0;
};

/// A person in the room, including the viewer.
struct RoomPerson {
  ViewerId id{};
  std::string name;
  Rgb8 color;
  std::optional<PersonPose> pose;  // nothing until it is known
  bool speaking = false;           // these two are known to viewers that hear
  bool muted = false;              // by an admin
};

struct RoomSnapshot {
  std::uint64_t revision = 0;  // grows with every change
  bool connected = false;
  std::string problem;  // why not connected, for display
  std::string room;
  ViewerRights rights;  // as of the last welcome by the hub
  std::optional<RigidTransform>
      start_pose;                   // world_from_viewer; viewer frame x right, y up, -z forward
  std::vector<RoomSensor> sensors;  // by id
  bool sensors_known = false;       // false: the hub has not named them yet
  ViewerId self{};
  std::vector<RoomPerson> people;  // empty without a connection
  std::shared_ptr<const RoomMarks::List> marks = std::make_shared<const RoomMarks::List>();
  std::uint64_t mark_refusals = 0;     // how often a change of marks had no effect
  std::string mark_refusal;            // why the last one had none
  std::uint64_t people_revision = 0;   // grows with every change of people and marks
  std::optional<ClockEstimate> clock;  // room time, once it is known
  SetId newest_set{};
  std::uint64_t sets_received = 0;
  std::uint64_t bytes_received = 0;
};

}  // namespace roomcast::client
