// SPDX-License-Identifier: Apache-2.0
// Room: the clients of a room and the messages that each of them gets. A pure state machine: it
// takes an event and the time, and returns actions (the paper's Algorithm 2: ids, forwarding,
// time-aligned frames, joins and leaves in any order). docs/spec/wire.md §3.
//
// A sensor is identified by its name: it leaves and comes back with the same ID and pose. A viewer
// is a new one each time.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/hub/access/entry.h"
#include "roomcast/hub/access/rate_limit.h"
#include "roomcast/hub/config/room_settings.h"
#include "roomcast/hub/room/frame_demand.h"
#include "roomcast/hub/room/frame_synchronizer.h"
#include "roomcast/hub/room/known_room.h"
#include "roomcast/hub/room/mark_list.h"
#include "roomcast/hub/room/playback_voices.h"
#include "roomcast/hub/room/pose_relay.h"
#include "roomcast/hub/room/remote_presence.h"
#include "roomcast/hub/room/room_action.h"
#include "roomcast/hub/room/room_stats.h"
#include "roomcast/hub/room/sensor_list.h"
#include "roomcast/hub/room/small_needs.h"
#include "roomcast/hub/room/start_pose.h"
#include "roomcast/hub/room/uplink_share.h"
#include "roomcast/hub/room/voice_relay.h"
#include "roomcast/hub/visibility/told_views.h"
#include "roomcast/hub/visibility/view_culling.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/control.pb.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::hub {

class Room {
 public:
  /// How often a viewer that is a hub may report its people. It reports when its roster changes.
  static constexpr double kPeopleReportsPerSecond = 20;

  /// `restores_poses`: restore the estimated poses of remembered sensors. Only where an aligner
  /// verifies them.
  Room(RoomSettings settings, std::string hub_version, bool restores_poses = true);

  /// Permissions and limits apply to clients that join from now on. The name stays the same.
  [[nodiscard]] RoomActions change(RoomSettings settings, RoomTime now);
  [[nodiscard]] const RoomSettings& settings() const { return settings_; }

  /// What was known before the hub was started: marks, and sensors, which get their IDs back when
  /// they join. Must be called before any event.
  void remember(KnownRoom known) {
    sensors_.remember(std::move(known.sensors));
    marks_.remember(std::move(known.marks));
  }

  // Events. Messages have passed wire::decode_control, parse_frame or parse_audio.

  /// A client was admitted with the permissions in `entry`.
  [[nodiscard]] RoomActions join(ConnectionId from, const wire::pb::Join& join, const Entry& entry,
                                 RoomTime now);
  /// Any later control message of a client.
  [[nodiscard]] RoomActions control(ConnectionId from, const wire::pb::Control& message,
                                    RoomTime now);
  [[nodiscard]] RoomActions frame(ConnectionId from, const wire::FrameHeader& header,
                                  net::MessageBuffer message, RoomTime now);
  /// Several frames that arrived together. Their messages are moved from.
  [[nodiscard]] RoomActions frames(std::span<IncomingFrame> together, RoomTime now);
  /// An audio packet of a viewer, or of a sensor's microphone.
  [[nodiscard]] RoomActions audio(ConnectionId from, const wire::AudioHeader& header,
                                  net::MessageBuffer message, RoomTime now);
  /// Mutes a viewer for all, also when it joins again with the same token; or ends that. Likewise a
  /// sensor's microphone (wire::speaker_of), until the sensor is forgotten.
  [[nodiscard]] RoomActions mute(ViewerId speaker, bool muted, RoomTime now);
  /// The reason for which frame() would refuse it; nothing: it would accept it.
  [[nodiscard]] std::optional<Refusal> fault_of(ConnectionId from, const wire::FrameHeader& header,
                                                RoomTime now);
  /// Frames of this sensor were dropped for a viewer, which needs a key frame to continue.
  [[nodiscard]] RoomActions key_needed(SensorId sensor, RoomTime now);
  /// A viewer's line takes less, or more, than before. No effect if it has left.
  [[nodiscard]] RoomActions small_needed(ConnectionId viewer, const SmallNeeds& needs,
                                         RoomTime now);
  /// Forgets a sensor; if it joins again it is a new one. Has no effect on a sensor that is online.
  [[nodiscard]] RoomActions forget(const std::string& sensor, RoomTime now);
  /// Whether other hubs have viewers for the sensors of this one.
  [[nodiscard]] RoomActions watch_elsewhere(bool is_watched, RoomTime now);
  /// A connection has closed.
  [[nodiscard]] RoomActions leave(ConnectionId from, RoomTime now);
  /// Time has passed: closes due sets and sends what is due.
  [[nodiscard]] RoomActions tick(RoomTime now);

  /// The time for the next tick() if no event happens before; nothing: none is needed.
  [[nodiscard]] std::optional<RoomTime> next_tick() const;

  [[nodiscard]] const std::string& name() const { return settings_.name; }
  /// The connections of all clients.
  [[nodiscard]] std::vector<ConnectionId> connections() const;
  [[nodiscard]] std::size_t online_sensor_count() const { return sensors_.online_count(); }
  [[nodiscard]] std::size_t viewer_count() const { return viewers_.size(); }
  [[nodiscard]] std::uint64_t closed_set_count() const { return set_stats_.sets; }
  [[nodiscard]] RoomStats stats() const;

 private:
  struct Viewer {
    ViewerId id;
    std::string name;
    std::uint32_t color_rgb = 0;
    bool may_nudge = false;  // it joined with an admin's token
    bool may_mark = false;
    bool records = false;
    bool relays = false;  // it is a hub that relays this room
    bool may_speak = false;
    bool hears = false;  // it wants audio packets
    std::string token_id;
    std::vector<SensorId> small = {};           // of these it gets the small rendition
    std::vector<SensorId> held_back = {};       // of these it gets key frames only
    SensorDetails details = {};                 // by what it sees
    wire::pb::ViewerStats reported_stats = {};  // reported by the viewer
    RateLimit people{kPeopleReportsPerSecond, 4 * kPeopleReportsPerSecond};
    std::uint64_t author_tag = 0;  // of its marks
    RateLimit marks{wire::kMaxMarksPerSecond, wire::kMaxMarksAtOnce};
  };

  void join_sensor(ConnectionId from, const wire::pb::Join& join, const Entry& entry, RoomTime now,
                   RoomActions& out);
  void forget_newest_frames();
  void join_viewer(ConnectionId from, const wire::pb::Join& join, const Entry& entry, RoomTime now,
                   RoomActions& out);
  void join_player(ConnectionId from, const wire::pb::Join& join, const Entry& entry, RoomTime now,
                   RoomActions& out);
  [[nodiscard]] RoomActions control_of_player(ConnectionId from, const wire::pb::Control& message,
                                              RoomTime now);
  void add_players_to(RoomStats& stats) const;
  [[nodiscard]] bool is_full() const;
  [[nodiscard]] RoomActions refuse_as_full(ConnectionId from, RoomTime now);
  void join_aligner(ConnectionId from, const Entry& entry, RoomTime now, RoomActions& out);
  void join_modeler(ConnectionId from, const Entry& entry, RoomTime now, RoomActions& out);
  [[nodiscard]] wire::pb::Control welcome_message(const Entry& entry) const;
  [[nodiscard]] bool is_watched() const;
  [[nodiscard]] bool wants_all() const;
  void look_at_wishes(RoomSensor& sensor) const;
  void share_uplink(RoomTime now);
  void update_demand(RoomTime now, RoomActions& out);
  void tell_demands_when_due(RoomTime now, RoomActions& out);
  void tell_demands(RoomTime now, RoomActions& out);
  [[nodiscard]] std::size_t sensors_in_each_set() const;
  void keep_bundle(RoomSensor& sensor, const wire::pb::CalibrationBundle& bundle, RoomTime now,
                   RoomActions& out);
  void lose_place(RoomSensor& sensor, RoomTime now, RoomActions& out);
  static void tell_depth_scale(RoomSensor& sensor, RoomActions& out);
  void ask_for_sightings(const wire::pb::SightingRequest& request, RoomActions& out);
  [[nodiscard]] static wire::pb::Control with_sensor_id(const RoomSensor& sensor,
                                                        wire::pb::Control message);
  void pass_to_aligners(wire::pb::Control message, RoomActions& out) const;
  void take_placements(const wire::pb::Placements& placements, RoomTime now, RoomActions& out);
  [[nodiscard]] bool may_nudge(ConnectionId from) const;
  [[nodiscard]] bool may_report_people(ConnectionId from) const;
  RoomActions take_people(ConnectionId from, const wire::pb::PeopleHere& people, RoomTime now);
  void take_poses(ConnectionId from, const wire::pb::ViewerPoses& poses, RoomTime now);
  [[nodiscard]] std::string why_not_mark(Viewer& viewer, RoomTime now);
  RoomActions take_mark(ConnectionId from, Viewer& viewer, const wire::pb::Mark& given,
                        RoomTime now);
  RoomActions remove_marks(ConnectionId from, Viewer& viewer, const wire::pb::RemoveMarks& removal,
                           RoomTime now);
  void tell_marks(ConnectionId newcomer, RoomActions& out) const;
  RoomActions set_guide(ViewerId viewer, bool guides);
  bool forget_people(const RemotePresence::Change& change);
  void add_voice(ConnectionId connection, const Viewer& viewer, RoomActions& out);
  void send_voices(RoomTime now, RoomActions& out);
  [[nodiscard]] std::optional<ViewerId> speaker_at(ConnectionId from);
  [[nodiscard]] std::optional<Eigen::Vector3f> place_of(ViewerId speaker);
  [[nodiscard]] bool may_hear(const Viewer& viewer) const;
  void mute_token(const std::string& token_id, bool muted);
  void change_recorded_voices(RoomTime now, RoomActions& out);
  void name_other_hubs(const wire::pb::Control& message, RoomActions& out);
  bool evict_for(const std::string& name);
  RoomSensor* known_or_new_sensor(const std::string& name, RoomActions& out);
  void ask_for_key(const RoomSensor& sensor, RoomActions& out, bool small = false);
  [[nodiscard]] bool is_wanted_small(SensorId sensor) const;
  void take_frame(IncomingFrame& frame, RoomTime now, RoomActions& out);
  void send_closed_sets(RoomTime now, RoomActions& out);
  void follow_surface(RoomSensor& sensor);
  void cull(RoomTime now, RoomActions& out);
  [[nodiscard]] static wire::pb::Control left_out(const Viewer& viewer);
  void tell_views(RoomTime now, RoomActions& out);
  void send_roster(RoomTime now, RoomActions& out);
  void place_unplaced_in_row();
  bool send_roster_when_due(RoomTime now, RoomActions& out);
  [[nodiscard]] wire::pb::Control roster_message();
  [[nodiscard]] std::vector<ConnectionId> viewer_connections() const;
  [[nodiscard]] std::vector<ConnectionId> readers_of_roster() const;
  [[nodiscard]] std::vector<ConnectionId> readers_of_poses() const;
  [[nodiscard]] wire::pb::Roster roster() const;
  [[nodiscard]] RigidTransform next_start_pose() const;
  [[nodiscard]] RoomActions refuse(ConnectionId from, wire::pb::ErrorCode code,
                                   std::string sentence, RoomTime now);

  RoomSettings settings_;
  const std::string hub_version_;
  const bool restores_poses_;
  SensorList sensors_;
  std::unordered_map<ConnectionId, Viewer> viewers_;
  std::vector<ConnectionId> aligners_;
  std::vector<ConnectionId> backplane_aligners_;  // of these, those that forward poses to hubs
  std::vector<ConnectionId> modelers_;
  wire::pb::SightingRequest wanted_sightings_;
  wire::pb::Control other_hubs_;  // the other hubs that have this room; empty: none
  RemotePresence remote_presence_;
  PoseRelay poses_;
  VoiceRelay voices_;
  PlaybackVoices playback_;
  ViewCulling culling_;
  ToldViews views_;
  std::set<std::string> muted_tokens_;
  MarkList marks_;
  std::optional<ViewerId> guide_;  // who shows everybody around
  FrameSynchronizer sets_;
  FrameDemand demand_;
  UplinkShare uplink_;
  bool is_watched_elsewhere_ = false;
  RoomStats set_stats_;  // the counters that change with frame sets
  std::uint32_t next_viewer_id_ = 1;
  std::uint32_t roster_revision_ = 0;
  RoomTime next_roster_{};
  bool roster_changed_ = false;  // some viewers do not have the newest one
};

}  // namespace roomcast::hub
