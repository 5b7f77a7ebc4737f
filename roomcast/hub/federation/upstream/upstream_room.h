// SPDX-License-Identifier: Apache-2.0
// UpstreamRoom: a room that is pulled from another hub, or from the next one where that is gone or
// hung: a viewer there, its sensors here. Threading: lives on one io_context, the rooms'.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <boost/asio/steady_timer.hpp>

#include "roomcast/client/credential.h"
#include "roomcast/client/hub_link.h"
#include "roomcast/core/log.h"
#include "roomcast/hub/federation/upstream/mirrored_room.h"

namespace roomcast::hub::federation {

struct UpstreamOptions {
  std::vector<net::HubUrl> hubs;  // at least one; the next is tried where one is gone
  client::Credential credential = {};     // a viewer's there
  /// How long a room is still pulled that nobody watches any more.
  std::chrono::milliseconds kept_unwatched{3000};
  LogSink log = {};
};

class UpstreamRoom final : private client::HubLinkEvents {
 public:
  /// A hub that is there says something every few hundred milliseconds, if asked. Each look whether
  /// it has to be asked wakes this one.
  static constexpr net::ConnectionTimings kTimings{.ping_after = std::chrono::milliseconds(300),
                                                   .give_up_after = std::chrono::milliseconds(600),
                                                   .close_within = std::chrono::milliseconds(500)};
  /// After it was refused: perhaps the room is opened there, or the token is renewed.
  static constexpr std::chrono::seconds kAskAgainAfter{4};

  /// Tokens for this room that hold no more, says the other hub.
  using Revoke = std::function<void(std::vector<hub::Claims>)>;

  UpstreamRoom(boost::asio::io_context& io, const UpstreamOptions& options, const std::string& room,
               MirroredRoom mirror, Revoke revoke);
  ~UpstreamRoom() override { timer_.cancel(); }

  [[nodiscard]] MirroredRoom& mirror() { return mirror_; }
  void said(ConnectionId to, const wire::pb::Control& message);

  /// In the room there.
  [[nodiscard]] bool is_welcome() const { return is_welcome_; }
  // But for what keeps the connection.
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
  boost::asio::steady_timer timer_;
};

}  // namespace roomcast::hub::federation
