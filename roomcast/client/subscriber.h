// SPDX-License-Identifier: Apache-2.0
// Subscriber: receives a room for a viewer: decodes frames and provides snapshots of the newest
// complete frame set. Frames are decoded on the network thread: a machine that decodes too slowly
// reads more slowly, and the hub then skips whole frame sets for it. Threading: thread-safe.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "roomcast/client/credential.h"
#include "roomcast/client/heard_voices.h"
#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"

namespace roomcast::client {

struct SubscriberOptions {
  std::string hub_url;
  std::string room;  // empty: the hub's only room
  Credential credential = {};
  std::string name;    // shown to others; may be empty
  bool hears = false;  // gets people's voices, and who is speaking
  /// It fuses the room's model: gets key frames only, no sensor sends for it, and it is in no
  /// roster. Takes an admin's token.
  bool is_modeler = false;
  /// A secret of this program, by which its marks are its own later; empty: a new one.
  std::string author_key = {};
  LogSink log;
  std::stop_token stop = {};  // ends the wait of open() for the hub
};

/// Display statistics of a viewer.
struct ShownStats {
  SetId newest_set{};
  double fps = 0;         // frame sets
  double latency_ms = 0;  // capture to shown, median of the last second
};

class Subscriber {
 public:
  /// Connects and joins. Errors as Publisher::open.
  static Result<std::unique_ptr<Subscriber>> open(SubscriberOptions options);
  ~Subscriber();

  /// Never null.
  [[nodiscard]] std::shared_ptr<const RoomSnapshot> snapshot() const;

  /// Waits until there is a snapshot newer than `revision`, or until `timeout`; gives the newest.
  [[nodiscard]] std::shared_ptr<const RoomSnapshot> wait_newer(
      std::uint64_t revision, std::chrono::milliseconds timeout) const;

  /// Sends this viewer's pose to the others. Does not wait (nor does send_stats); lost without a
  /// connection.
  void send_pose(const PersonPose& pose);
  /// These three are requests without an answer of their own: room_requests.h waits for what comes
  /// of them. Lost without a connection.
  void send_mark(const wire::pb::Mark& mark);
  void send_removal(std::span<const std::uint32_t> marks);
  void send_prior(SensorId sensor, const RigidTransform& world_from_depth);

  /// Asks for a key frame of the sensor, which comes with the others' frames. Lost without a
  /// connection; the hub passes on two a second at most.
  void ask_for_key(SensorId sensor);

  /// Sends a packet of this viewer's voice: 20 ms of Opus, at most wire::kMaxAudioPayloadBytes.
  /// `ends`: a pause follows. Does not wait. Lost without a connection, or without room time.
  void say(std::vector<std::uint8_t> opus, bool ends, HostTime first_sample);
  /// The next packet of somebody's voice, for a viewer that hears; nothing at the timeout, or once
  /// the connection has ended for good.
  [[nodiscard]] std::optional<HeardPacket> next_voice(std::chrono::milliseconds timeout);

  /// Statistics for the hub, to be sent once a second.
  void send_stats(const ShownStats& stats);

  /// The reason why the connection ended for good, once it has.
  [[nodiscard]] std::optional<Error> failure() const;

 private:
  class Link;
  explicit Subscriber(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::client
