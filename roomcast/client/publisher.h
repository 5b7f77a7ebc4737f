// SPDX-License-Identifier: Apache-2.0
// Publisher: sends one sensor's frames to the hub (the paper's Algorithm 1, "send"). If the network
// does not keep up, it makes the sensor's loop skip frames before they are encoded, so that no
// encoded frame is lost on the way to the network. Sound goes ahead of frames. Threading: one
// thread calls all methods that do not say otherwise; the network has a thread of its own.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "roomcast/client/credential.h"
#include "roomcast/client/uplink/uplink.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/geometry/rigid_transform.h"
#include "roomcast/net/message_buffer.h"
#include "roomcast/net/socket_tuning.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

struct PublisherOptions {
  std::string hub_url;  // "ws://host:port", "host:port", ...
  std::string room;     // empty: the hub's only room
  Credential credential = {};
  std::string name;  // the sensor's identity in the room
  SensorCalibration calibration;
  std::optional<RigidTransform> world_from_depth;
  double fps = 30;
  bool send_unwatched = false;         // frames are wanted while nobody watches, too
  std::optional<net::Pace> pace = {};  // of what is sent; nothing: as the network allows
  bool estimate_uplink = false;  // and send at the pace that the line carries; not with `pace`
  bool follows_rate = false;     // it keeps to the rate that the hub gives it: demand()
  bool takes_views = false;      // it wants to know from where it is looked at: views()
  bool wait_for_hub = false;     // keep trying if there is no hub at first; else open() fails
  /// How this sensor sends, and what an admin's request for other settings goes to, on the
  /// network's thread; nothing: it takes no requests.
  std::optional<wire::pb::SensorSettings> settings = {};
  std::function<void(const wire::pb::SettingsRequest&)> on_settings_request = {};
  std::function<void(const std::string& token)> on_token = {};  // that a code was exchanged for
  LogSink log;
  std::stop_token stop = {};  // ends the wait of open() for the hub
};

struct PublisherStats {
  std::uint64_t frames_sent = 0;
  std::uint64_t frames_skipped = 0;  // skipped by next_turn(), or lost in publish()
  std::uint64_t bytes_sent = 0;
  std::size_t frames_waiting = 0;  // published, and not on the network yet: 0..kMaxFramesWaiting
};

class Publisher {
 public:
  /// With so many frames unsent there is no turn: one being written, one ready. More would only add
  /// delay. One only if the uplink is estimated: its frames are made for what the line carries.
  static constexpr std::size_t kMaxFramesWaiting = 2;

  /// Connects and joins. kInvalidArgument: not a hub's address. kUnavailable, kNotFound,
  /// kUnsupported, kClosed: the reason why there is no connection, or why the hub refuses this
  /// sensor.
  static Result<std::unique_ptr<Publisher>> open(PublisherOptions options);
  ~Publisher();

  /// The frames that the hub wants of this sensor.
  struct Demand {
    bool is_watched = true;  // somebody is in the room, or records it
    bool is_seen = true;     // and sees what this sensor shows
    bool base_only = false;  // and needs layer 0 only
    double mbit = 0;         // the sensor's share of the room's uplink, Mbit/s; 0: any rate
    bool small = false;      // some viewer's line takes no more than its small rendition
  };
  /// By the hub's last word. Everything is wanted without a connection, and with `send_unwatched`,
  /// except for the rate. Thread-safe.
  [[nodiscard]] Demand demand() const;
  /// Whether anybody receives this sensor's frames. Thread-safe.
  [[nodiscard]] bool frames_wanted() const;
  /// With `takes_views`: the cones in which this sensor's viewers see, in its depth frame. Null:
  /// somebody gets everything, or may. Another pointer: they have changed. Thread-safe.
  [[nodiscard]] std::shared_ptr<const wire::pb::WatchedFrom> views() const;
  /// Sends at most at this pace from now on, on later connections too; nothing: as the network
  /// allows.
  void set_pace(std::optional<double> payload_bytes_per_s);
  /// Waits until frames are wanted, at most `patience`. Also returns when `stop` is requested or
  /// the connection has ended for good.
  void wait_until_wanted(std::chrono::milliseconds patience, const std::stop_token& stop);

  /// Permission to encode and publish one frame.
  struct Turn {
    std::uint64_t session = 0;
    bool want_key = false;
    bool want_small_key = false;  // of the small rendition
    double rate_share = 1;        // share of the full rate that the network carries: see SendRate
  };

  /// Nothing: skip this frame (no connection, room time not known yet, or frames are queued).
  [[nodiscard]] std::optional<Turn> next_turn();

  /// A buffer with space for the header; append the payload to its `appendable()`.
  [[nodiscard]] static net::MessageBuffer begin_frame();

  /// Whether the wire's limit allows a frame of this size.
  [[nodiscard]] static bool fits(const net::MessageBuffer& message);

  /// The number and time of a published frame, for logs and tests.
  struct Published {
    std::uint32_t seq = 0;
    RoomTime capture_time{};
  };
  /// Nothing: the connection broke meanwhile, or the frame exceeds the wire's limit.
  std::optional<Published> publish(const Turn& turn, const codec::EncodedFrameInfo& info,
                                   HostTime capture_time, net::MessageBuffer message);
  /// Publishes a frame of the small rendition, before the other one of this turn.
  void publish_small(const Turn& turn, const codec::EncodedFrameInfo& info, HostTime capture_time,
                     net::MessageBuffer message);

  /// Sends the calibration bundle, by which the sensor can be placed: now, and again after every
  /// reconnection.
  void send_bundle(wire::pb::CalibrationBundle bundle);

  /// Sends what the sensor has to say at the moment: its health, sightings, instants, answers. Lost
  /// without a connection. Thread-safe.
  void send(wire::pb::Control message);

  /// Whether the room lets the sensor's microphone be heard; false without a connection, too.
  /// Thread-safe, as is the next one.
  [[nodiscard]] bool may_speak() const;
  /// Sends a packet of the microphone's sound: 20 ms of Opus, at most wire::kMaxAudioPayloadBytes.
  /// `ends`: a pause follows. Lost without a connection, or without room time, or while the room
  /// does not permit it.
  void say(std::vector<std::uint8_t> opus, bool ends, HostTime first_sample);

  /// Reports that the sensor was moved: its known pose is invalid. A new bundle should follow.
  void report_moved();

  /// The sightings that the room's aligner requests; nothing if it requests none, or without a
  /// connection.
  [[nodiscard]] wire::pb::SightingRequest wanted_sightings() const;
  /// The factor by which the sensor must multiply its readings, by the hub's last word; nothing:
  /// the hub said none.
  [[nodiscard]] std::optional<double> depth_scale() const;
  /// Converts to room time; nothing while room time is not known.
  [[nodiscard]] std::optional<RoomTime> room_time(HostTime time) const;

  /// With `estimate_uplink`: the line to the hub, by estimate. Thread-safe.
  [[nodiscard]] std::optional<Uplink> uplink() const;
  /// Bytes of all that was sent besides frames. Thread-safe.
  [[nodiscard]] std::uint64_t control_bytes() const;

  /// The reason why the connection ended for good, once it has. Thread-safe, as are the next two.
  [[nodiscard]] std::optional<Error> failure() const;
  /// The reason why there is no connection at the moment; nothing while there is one.
  [[nodiscard]] std::optional<Error> problem() const;
  [[nodiscard]] PublisherStats stats() const;

 private:
  class Link;
  explicit Publisher(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::client
