// SPDX-License-Identifier: Apache-2.0
// Subscriber: a viewer's way to the room: decodes what comes and offers the newest whole frame set.
// Frames are decoded on the network's thread: a machine that cannot decode fast enough reads more
// slowly, and the hub then leaves out whole sets for it. Threading: thread-safe.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "roomcast/client/credential.h"
#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/core/log.h"
#include "roomcast/core/result.h"

namespace roomcast::client {

struct SubscriberOptions {
  std::string hub_url;
  std::string room;  // empty: the hub's only one
  Credential credential = {};
  std::string name;  // shown to others; may be empty
  LogSink log;
};

/// How well a viewer can show what comes.
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

  /// Tells the others where this viewer is. Neither waits; while there is no connection it is lost.
  void send_pose(const PersonPose& pose);
  /// For the hub's figures, once a second.
  void send_stats(const ShownStats& stats);

  /// Why it is over for good, once it is.
  [[nodiscard]] std::optional<Error> failure() const;

 private:
  class Link;
  explicit Subscriber(std::unique_ptr<Link> link);
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::client
