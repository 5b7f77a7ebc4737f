// SPDX-License-Identifier: Apache-2.0
#include "roomcast/wire/control_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "roomcast/wire/limits.h"
#include "roomcast/wire/mark_check.h"
#include "roomcast/wire/name_check.h"
#include "roomcast/wire/settings_check.h"
#include "roomcast/wire/visibility_check.h"

namespace roomcast::wire {
namespace {

Error malformed(std::string sentence) {
  return {ErrorCode::kMalformed, std::move(sentence)};
}

template <class... Numbers>
bool all_finite(Numbers... numbers) {
  return (std::isfinite(numbers) && ...);
}

Status check_fps(double fps) {
  if (!(fps > 0 && fps <= kMaxFps))
    return malformed("a frame rate must be above 0 and at most 240 per second");
  return {};
}

/// Checks that the matrix is a row-major rigid 4x4. Rounding of a millimetre and a milliradian is
/// accepted; scaling and mirroring are not.
Status check_rigid(const google::protobuf::RepeatedField<double>& m, const char* what) {
  const auto fault = [&](const char* reason) {
    return malformed(std::string(what) + " " + reason);
  };
  if (m.size() != 16) return fault("must have 16 numbers");
  for (const double number : m) {
    if (!std::isfinite(number) || std::abs(number) > kMaxPosition_m)
      return fault("has a number out of range");
  }
  if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
    return fault("must end with the row 0 0 0 1");
  const auto dot = [&](int a, int b) {
    return m[a] * m[b] + m[a + 4] * m[b + 4] + m[a + 8] * m[b + 8];
  };
  constexpr double kTolerance = 2e-3;
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) {
      if (std::abs(dot(a, b) - (a == b ? 1 : 0)) > kTolerance)
        return fault("must be a rotation and a translation");
    }
  }
  const double determinant = m[0] * (m[5] * m[10] - m[6] * m[9]) -
                             m[1] * (m[4] * m[10] - m[6] * m[8]) +
                             m[2] * (m[4] * m[9] - m[5] * m[8]);
  if (determinant < 0) return fault("must not mirror");
  return {};
}

Status check_intrinsics(const pb::Intrinsics& camera, unsigned min_side, unsigned max_side,
                        const char* what) {
  const auto side_ok = [&](unsigned side) { return side >= min_side && side <= max_side; };
  if (!side_ok(camera.width()) || !side_ok(camera.height())) {
    return malformed(std::string(what) + " pictures are " + std::to_string(min_side) + " to " +
                     std::to_string(max_side) + " pixels wide and high");
  }
  const bool finite = all_finite(camera.fx(), camera.fy(), camera.cx(), camera.cy(), camera.k1(),
                                 camera.k2(), camera.k3(), camera.p1(), camera.p2());
  if (!finite || camera.fx() <= 0 || camera.fy() <= 0) {
    return malformed(std::string(what) +
                     " intrinsics need positive focal lengths and finite numbers");
  }
  return {};
}

Status check_calibration(const pb::Calibration& calibration) {
  if (auto s = check_intrinsics(calibration.depth(), kMinDepthSide, kMaxDepthSide, "depth"); !s)
    return s;
  if (auto s = check_intrinsics(calibration.color(), 1, kMaxImageSide, "colour"); !s) return s;
  return check_rigid(calibration.color_from_depth(), "color_from_depth");
}

Status check_sensor_role(const pb::SensorRole& sensor) {
  if (auto s = check_fps(sensor.fps()); !s) return s;
  if (auto s = check_calibration(sensor.calibration()); !s) return s;
  if (auto s = check_settings(sensor.settings()); !s) return s;
  if (sensor.world_from_depth().empty()) return {};
  return check_rigid(sensor.world_from_depth(), "world_from_depth");
}

Status check_viewer_role(const pb::ViewerRole& viewer) {
  if (viewer.author_key().size() > kMaxAuthorKeyBytes)
    return malformed("an author's key must have at most 64 bytes");
  if (!viewer.plays().empty() && (viewer.records() || viewer.relays()))
    return malformed("who plays a recording neither records nor relays the room");
  return check_text(viewer.plays(), kMaxRecordingNameBytes, "the recording's name");
}

Status check_join(const pb::Join& join) {
  if (auto s = check_name(join.room(), "room"); !s) return s;
  if (auto s = check_name(join.name(), "client"); !s) return s;
  if (auto s = check_name(join.code(), "code"); !s) return s;
  if (join.token().size() > kMaxTokenBytes) {
    return Error{ErrorCode::kTooLarge,
                 "a token must have at most " + std::to_string(kMaxTokenBytes) + " bytes"};
  }
  switch (join.role_case()) {
    case pb::Join::kSensor:
      if (join.name().empty()) return malformed("a sensor needs a name");
      return check_sensor_role(join.sensor());
    case pb::Join::kViewer:
      return check_viewer_role(join.viewer());
    case pb::Join::kAligner:
    case pb::Join::kModeler:
      return {};
    default:
      return malformed("a Join must be a sensor's, a viewer's, an aligner's or a modeler's");
  }
}

/// Whether a point (x, y, z in metres) is in the allowed range.
template <class Place>
bool is_within_reach(const Place& place) {
  const auto is_near = [](float metres) {
    return std::abs(metres) <= kMaxPosition_m;
  };  // false for NaN
  return is_near(place.x()) && is_near(place.y()) && is_near(place.z());
}

Status check_pose(const pb::Pose& pose) {
  const double norm2 =
      pose.qx() * pose.qx() + pose.qy() * pose.qy() + pose.qz() * pose.qz() + pose.qw() * pose.qw();
  if (!is_within_reach(pose)) return malformed("a pose is out of range");
  if (!(std::abs(norm2 - 1) < 0.01)) return malformed("a pose's quaternion must have unit length");
  return {};
}

Status check_viewer_pose(const pb::ViewerPose& pose) {
  if (!pose.has_head()) return malformed("a viewer's pose needs a head");
  for (const pb::Pose* part : {&pose.head(), pose.has_left_hand() ? &pose.left_hand() : nullptr,
                               pose.has_right_hand() ? &pose.right_hand() : nullptr}) {
    if (part == nullptr) continue;
    if (auto s = check_pose(*part); !s) return s;
  }
  const pb::Beam& beam = pose.pointer();  // all zero if there is none
  if (!is_within_reach(beam.from()) || !is_within_reach(beam.to()))
    return malformed("a pointer's beam is out of range");
  return check_view_half_angles(
      {pose.view_half_angle(), pose.view_half_width(), pose.view_half_height()});
}

Status check_note(const std::string& note) {
  if (note.size() > kMaxNoteBytes) {
    return Error{ErrorCode::kTooLarge,
                 "a note must have at most " + std::to_string(kMaxNoteBytes) + " bytes"};
  }
  return {};
}

Status check_expected_error(float error_mm) {
  if (!(error_mm >= 0 && std::isfinite(error_mm)))
    return malformed("an error must be 0 mm or more");
  return {};
}

Status check_sensor_id(std::uint32_t id) {
  if (id > std::numeric_limits<std::uint16_t>::max())
    return malformed("a sensor's ID must have at most 16 bits");
  return {};
}

/// `or_none`: 0 is allowed.
Status check_depth_scale(double factor, bool or_none) {
  if (or_none && factor == 0) return {};
  if (!(factor >= kMinDepthScale && factor <= kMaxDepthScale))
    return malformed("a factor on a sensor's readings must be 0.5 to 2");
  return {};
}

Status check_instant(const pb::DepthInstant& instant) {
  if (auto s = check_sensor_id(instant.sensor_id()); !s) return s;
  if (instant.depth().empty()) return malformed("an instant needs depth");
  return check_depth_scale(instant.depth_scale(), true);
}

Status check_bundle(const pb::CalibrationBundle& bundle) {
  if (auto s = check_sensor_id(bundle.sensor_id()); !s) return s;
  if (bundle.depth().empty()) return malformed("a calibration bundle needs depth");
  if (auto s = check_depth_scale(bundle.depth_scale(), true); !s) return s;
  if (bundle.up().empty()) return {};
  if (bundle.up_size() != 3) return malformed("up must be 3 numbers");
  const double norm2 =
      bundle.up(0) * bundle.up(0) + bundle.up(1) * bundle.up(1) + bundle.up(2) * bundle.up(2);
  if (!(std::abs(norm2 - 1) < 0.01)) return malformed("up must have unit length");
  return {};
}

Status check_sightings(const pb::Sightings& sightings) {
  if (auto s = check_sensor_id(sightings.sensor_id()); !s) return s;
  if (sightings.heads_size() > kMaxSightings || sightings.tags_size() > kMaxSightings) {
    return Error{ErrorCode::kTooLarge, "a message must have at most " +
                                           std::to_string(kMaxSightings) + " sightings of a kind"};
  }
  const auto in_range = [](float metres) { return std::abs(metres) <= kMaxPosition_m; };
  for (const auto& head : sightings.heads()) {
    if (!in_range(head.x()) || !in_range(head.y()) || !in_range(head.z()))
      return malformed("a head is out of range");
  }
  for (const auto& tag : sightings.tags()) {
    if (tag.corners_size() != 12) return malformed("a tag needs four corners of three numbers");
    if (!std::ranges::all_of(tag.corners(), in_range)) return malformed("a tag is out of range");
  }
  return {};
}

Status check_nudge(const pb::Nudge& nudge) {
  if (auto s = check_sensor_id(nudge.sensor_id()); !s) return s;
  return check_rigid(nudge.world_from_depth(), "world_from_depth");
}

Status check_placements(const pb::Placements& placements) {
  if (placements.sensors_size() > int{kMaxSensors}) {
    return Error{ErrorCode::kTooLarge, "there are more placements than sensors in a room"};
  }
  for (const auto& sensor : placements.sensors()) {
    if (auto s = check_sensor_id(sensor.sensor_id()); !s) return s;
    if (auto s = check_note(sensor.note()); !s) return s;
    if (auto s = check_expected_error(sensor.expected_error_mm()); !s) return s;
    if (auto s = check_depth_scale(sensor.depth_scale(), true); !s) return s;
    if (sensor.world_from_depth().empty()) continue;
    if (auto s = check_rigid(sensor.world_from_depth(), "world_from_depth"); !s) return s;
  }
  return {};
}

Status check_viewer_names(const google::protobuf::RepeatedPtrField<pb::ViewerEntry>& viewers) {
  for (const auto& viewer : viewers) {
    if (auto s = check_name(viewer.name(), "viewer"); !s) return s;
  }
  return {};
}

Status check_roster(const pb::Roster& roster) {
  if (roster.sensors_size() > int{kMaxSensors} || roster.viewers_size() > int{kMaxViewers}) {
    return Error{ErrorCode::kTooLarge,
                 "a roster lists more sensors or viewers than a room may have"};
  }
  for (const auto& sensor : roster.sensors()) {
    if (auto s = check_sensor_id(sensor.id()); !s) return s;
    if (auto s = check_name(sensor.name(), "sensor"); !s) return s;
    if (auto s = check_calibration(sensor.calibration()); !s) return s;
    if (auto s = check_rigid(sensor.world_from_depth(), "world_from_depth"); !s) return s;
    if (auto s = check_fps(sensor.fps()); !s) return s;
    if (auto s = check_note(sensor.placement_note()); !s) return s;
    if (auto s = check_expected_error(sensor.expected_error_mm()); !s) return s;
    if (auto s = check_depth_scale(sensor.depth_scale(), true); !s) return s;
  }
  return check_viewer_names(roster.viewers());
}

Status check_welcome(const pb::Welcome& welcome) {
  if (auto s = check_sensor_id(welcome.sensor_id()); !s) return s;
  if (welcome.start_pose().empty()) return {};
  return check_rigid(welcome.start_pose(), "start_pose");
}

Status check_viewer_poses(const pb::ViewerPoses& message) {
  if (message.poses_size() > kMaxPosesPerMessage) {
    return Error{ErrorCode::kTooLarge, "there are more poses than a message may have"};
  }
  for (const auto& pose : message.poses()) {
    if (auto s = check_viewer_pose(pose); !s) return s;
  }
  return {};
}

Status check_stats(const pb::ViewerStats& stats) {
  if (!all_finite(stats.shown_fps(), stats.latency_ms()))
    return malformed("a viewer's statistics must be finite numbers");
  return {};
}

Status check_health(const pb::SensorHealth& health) {
  const bool is_share = health.flickering() >= 0 && health.flickering() <= 1;
  const bool is_ratio = health.noise_ratio() >= 0 && health.noise_ratio() <= kMaxNoiseRatio;
  if (!is_share || !is_ratio) return malformed("a sensor's health must be a share and a ratio");
  return {};
}

Status check_other_hubs(const pb::OtherHubs& message) {
  if (message.urls_size() > kMaxOtherHubs) {
    return Error{ErrorCode::kTooLarge, "there are too many other hubs"};
  }
  for (const std::string& url : message.urls()) {
    const bool is_plain =
        std::ranges::all_of(url, [](unsigned char c) { return c > 0x20 && c < 0x7f; });
    if (!is_plain || url.size() > kMaxUrlBytes)
      return malformed("a hub's address must be a short URL");
  }
  return {};
}

Status check_people_here(const pb::PeopleHere& message) {
  if (message.people_size() > kMaxPeopleHere) {
    return Error{ErrorCode::kTooLarge, "there are more people than one hub may report to another"};
  }
  return check_viewer_names(message.people());
}

Status check_revoked_tokens(const pb::RevokedTokens& message) {
  if (message.tokens_size() > kMaxRevokedTokens) {
    return Error{ErrorCode::kTooLarge, "there are more revoked tokens than a message may have"};
  }
  for (const auto& token : message.tokens()) {
    if (token.id().empty()) return malformed("a revoked token needs an ID");
    for (const std::string* text : {&token.id(), &token.room(), &token.role()}) {
      if (auto s = check_name(*text, "token"); !s) return s;
    }
  }
  return {};
}

Status check_voices(const pb::Voices& voices) {
  const auto is_crowd = [](int count) { return count > int{kMaxViewers}; };
  if (is_crowd(voices.speaking_size()) || is_crowd(voices.muted_size()))
    return Error{ErrorCode::kTooLarge, "there are more voices than viewers in a room"};
  return {};
}

}  // namespace

Status check_control(const pb::Control& control) {
  switch (control.message_case()) {
    case pb::Control::kJoin:
      return check_join(control.join());
    case pb::Control::kWelcome:
      return check_welcome(control.welcome());
    case pb::Control::kRoster:
      return check_roster(control.roster());
    case pb::Control::kKeyRequest:
      return check_sensor_id(control.key_request().sensor_id());
    case pb::Control::kViewerPose:
      return check_viewer_pose(control.viewer_pose());
    case pb::Control::kViewerPoses:
      return check_viewer_poses(control.viewer_poses());
    case pb::Control::kViewerStats:
      return check_stats(control.viewer_stats());
    case pb::Control::kSensorHealth:
      return check_health(control.sensor_health());
    case pb::Control::kCoarseDepth:
    case pb::Control::kFrameDemand:
    case pb::Control::kUnseenSensors:
    case pb::Control::kWatchedFrom:
      return check_visibility(control);
    case pb::Control::kCalibrationBundle:
      return check_bundle(control.calibration_bundle());
    case pb::Control::kPlacements:
      return check_placements(control.placements());
    case pb::Control::kSightings:
      return check_sightings(control.sightings());
    case pb::Control::kDepthInstant:
      return check_instant(control.depth_instant());
    case pb::Control::kDepthScale:
      return check_depth_scale(control.depth_scale().factor(), false);
    case pb::Control::kNudge:
      return check_nudge(control.nudge());
    case pb::Control::kOtherHubs:
      return check_other_hubs(control.other_hubs());
    case pb::Control::kPeopleHere:
      return check_people_here(control.people_here());
    case pb::Control::kRevokedTokens:
      return check_revoked_tokens(control.revoked_tokens());
    case pb::Control::kVoices:
      return check_voices(control.voices());
    case pb::Control::kMarks:
      return check_marks(control.marks());
    case pb::Control::kRemoveMarks:
      return check_remove_marks(control.remove_marks());
    case pb::Control::kSettingsRequest:
      return check_settings(control.settings_request().settings());
    case pb::Control::kSettingsAnswer:
      return check_settings_answer(control.settings_answer());
    case pb::Control::kMark:  // the room refuses wrong ones with a sentence, and keeps the viewer
    case pb::Control::kGuide:
    case pb::Control::kSetEnd:
    case pb::Control::kSightingRequest:
    case pb::Control::kSensorMoved:
    case pb::Control::kClockPing:
    case pb::Control::kClockPong:
    case pb::Control::kError:
    case pb::Control::MESSAGE_NOT_SET:
      return {};
  }
  return {};
}

}  // namespace roomcast::wire
