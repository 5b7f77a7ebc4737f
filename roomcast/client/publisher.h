// SPDX-License-Identifier: Apache-2.0
// Publisher: one sensor's way to the hub (the paper's Algorithm 1, "send"). It asks the sensor's
// loop to leave frames out before they are encoded when the network does not keep up, so that
// nothing encoded is ever lost in between. Threading: one thread calls next_turn(), begin_frame(),
// publish() and what else is sent or asked; the network has a thread of its own.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "roomcast/client/credential.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

struct PublisherOptions {
  std::string hub_url;  // "ws://host:port", "host:port", ...
  std::string room;     // empty: the hub's only one
  Credential credential = {};
  std::string name;  // the sensor's identity in the room
  SensorCalibration calibration;
  std::optional<RigidTransform> world_from_depth;
  double fps = 30;
  bool wait_for_hub = false;  // keep trying when there is no hub at first; else open() fails
  LogSink log;
};

struct PublisherStats {
  std::uint64_t frames_sent = 0;
  std::uint64_t frames_skipped = 0;  // turns that were refused
  std::uint64_t bytes_sent = 0;
};

class Publisher {
 public:
  /// Connects and joins. kInvalidArgument: not a hub's address. kUnavailable, kNotFound,
  /// kUnsupported, kClosed: why there is no connection, or why the hub refuses this sensor.
  static Result<std::unique_ptr<Publisher>> open(PublisherOptions options);
  ~Publisher();

  /// Permission to encode and publish one frame.
  struct Turn {
    std::uint64_t session = 0;
    bool want_key = false;
    double rate_share = 1;  // of the full rate, what the network carries: see SendRate
  };

  /// Nothing: leave this frame out (no connection, room time not known yet, or frames pile up).
  [[nodiscard]] std::optional<Turn> next_turn();

  /// Room for the header; append the payload to its `appendable()`.
  [[nodiscard]] static net::MessageBuffer begin_frame();

  /// What became of a frame, for logs and tests.
  struct Published {
    std::uint32_t seq = 0;
    RoomTime capture_time{};
  };
  /// Nothing: the connection broke meanwhile, or the frame exceeds the wire's limit.
  std::optional<Published> publish(const Turn& turn, const codec::EncodedFrameInfo& info,
                                   HostTime capture_time, net::MessageBuffer message);

  /// What the sensor sees while nothing moves, so that it can be placed. Sent now, and again after
  /// every reconnection.
  void send_bundle(wire::pb::CalibrationBundle bundle);

  /// The sensor was moved: what was known of its place no longer holds. A new bundle should follow.
  void say_moved();

  /// What the room's aligner wants sensors to look out for; nothing while it does not, or while
  /// there is no connection.
  [[nodiscard]] wire::pb::SightingRequest wanted_sightings() const;
  void send_sightings(wire::pb::Sightings sightings);
  /// Nothing while room time is not known.
  [[nodiscard]] std::optional<RoomTime> room_time(HostTime time) const;

  /// Why it is over for good, once it is.
  [[nodiscard]] std::optional<Error> failure() const;
  [[nodiscard]] PublisherStats stats() const;

 private:
  class Link;
  explicit Publisher(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::client
