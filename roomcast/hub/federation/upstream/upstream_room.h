// SPDX-License-Identifier: Apache-2.0
// UpstreamRoom: a room pulled from another hub, or from the next one if that is gone or hangs. It
// joins there as a viewer and mirrors the sensors here. Threading: runs on one io_context, the
// rooms'.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/client/credential.h"
#include "roomcast/client/hub_link.h"
#include "roomcast/core/log.h"
#include "roomcast/hub/federation/upstream/mirrored_room.h"
#include "roomcast/net/timer.h"

namespace roomcast::hub::federation {

struct UpstreamOptions {
  std::vector<net::HubUrl> hubs;       // at least one; if one is gone the next is tried
  client::Credential credential = {};  // of a viewer at that hub
  /// How long a room is still pulled after its last viewer has left.
  std::chrono::milliseconds kept_unwatched{3000};
  LogSink log = {};
};

class UpstreamRoom final : public BackplaneRoom, private client::HubLinkEvents {
 public:
  /// A live hub answers a ping within a few hundred milliseconds. Each check whether a ping is due
  /// wakes this hub.
  static constexpr net::ConnectionTimings kTimings{.ping_after = std::chrono::milliseconds(300),
                                                   .give_up_after = std::chrono::milliseconds(600),
                                                   .close_within = std::chrono::milliseconds(500)};
  /// After a refusal: the room may be opened there, or the token renewed.
  static constexpr std::chrono::seconds kRejoinAfter{4};

  /// Called with the tokens for this room that the other hub has revoked.
  using Revoke = std::function<void(std::vector<hub::Claims>)>;

  UpstreamRoom(boost::asio::io_context& io, const UpstreamOptions& options, const std::string& room,
               MirroredRoom mirror, Revoke revoke);

  [[nodiscard]] MirroredRoom& mirror() { return mirror_; }
  void on_room_message(ConnectionId to, const wire::pb::Control& message) override;
  void on_removed(ConnectionId connection) override { mirror_.on_removed(connection); }

  /// Whether the other hub has admitted us to the room.
  [[nodiscard]] bool is_welcome() const { return is_welcome_; }
  // Traffic without that for keeping the connection alive.
  [[nodiscard]] const hub::BackplaneTraffic& sent() const { return sent_; }
  [[nodiscard]] const hub::BackplaneTraffic& received() const { return received_; }

 private:
  void join();
  void send(const wire::pb::Control& message);
  void on_welcome(const wire::pb::Welcome& welcome) override;
  void on_control(const wire::pb::Control& message) override;
  void on_frame(net::MessageBuffer message) override;
  void on_frames_done() override { mirror_.frames_done(); }
  net::FramedMessagePtr next_frame() override { return nullptr; }
  void on_clock(const client::ClockEstimate& estimate) override;
  void on_down(const Error& reason, bool final) override;

  const UpstreamOptions& options_;
  const std::string room_;
  MirroredRoom mirror_;
  const Revoke revoke_;
  boost::asio::io_context& io_;
  std::optional<client::HubLink> link_;
  bool is_welcome_ = false;
  hub::BackplaneTraffic sent_, received_;
  bool is_down_ = false;  // since the last welcome
  net::Timer timer_;
};

}  // namespace roomcast::hub::federation
