// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/federation/upstream/upstream_room.h"

#include <utility>

#include "roomcast/hub/runtime/revoked_message.h"

namespace roomcast::hub::federation {

namespace wpb = wire::pb;

namespace {

wpb::Join join_message(const UpstreamOptions& options, const std::string& room) {
  wpb::Join join;
  join.set_room(room);
  join.set_name("hub");
  show(options.credential, join);
  join.mutable_viewer()->set_relays(true);
  return join;
}

void count(std::size_t bytes, hub::BackplaneTraffic& traffic) {
  ++traffic.messages;
  traffic.bytes += bytes;
}

}  // namespace

UpstreamRoom::UpstreamRoom(boost::asio::io_context& io, const UpstreamOptions& options,
                           const std::string& room, MirroredRoom mirror, Revoke revoke)
    : options_(options),
      room_(room),
      mirror_(std::move(mirror)),
      revoke_(std::move(revoke)),
      io_(io),
      timer_(io) {
  join();
}

void UpstreamRoom::join() {
  client::HubLinkEvents& events = *this;
  link_.emplace(
      io_, options_.hubs, join_message(options_, room_), events,
      client::HubLink::Options{.timings = kTimings, .pings = client::PingSchedule::kOfHub});
  link_->start();
}

void UpstreamRoom::on_room_message(ConnectionId to, const wpb::Control& message) {
  const auto answer = mirror_.on_room_message(to, message);
  if (answer && is_welcome_) send(*answer);
}

void UpstreamRoom::send(const wpb::Control& message) {
  count(message.ByteSizeLong(), sent_);
  link_->send(message);
}

void UpstreamRoom::on_welcome(const wpb::Welcome& welcome) {
  is_down_ = false;
  is_welcome_ = true;
  for (const wpb::Control& first : mirror_.on_welcome(welcome.viewer_id())) send(first);
}

void UpstreamRoom::on_control(const wpb::Control& message) {
  count(message.ByteSizeLong(), received_);
  if (message.has_roster()) mirror_.on_roster(message.roster());
  if (message.has_viewer_poses()) mirror_.on_poses(message.viewer_poses());
  if (message.has_revoked_tokens()) {
    auto revoked = hub::revoked_claims(message.revoked_tokens(), room_);
    if (!revoked.empty()) revoke_(std::move(revoked));
  }
}

void UpstreamRoom::on_frame(net::MessageBuffer message) {
  count(message.size(), received_);
  mirror_.frame(std::move(message));
}

void UpstreamRoom::on_clock(const client::ClockEstimate& estimate) {
  mirror_.set_clock(estimate);
}

void UpstreamRoom::on_down(const Error& reason, bool final) {
  is_welcome_ = false;
  mirror_.on_hub_lost();
  if (final) timer_.once(kRejoinAfter, [this] { join(); });
  if (std::exchange(is_down_, true) || !options_.log) return;
  options_.log(LogLevel::kWarning, "room \"" + room_ + "\" of another hub: " + reason.message);
}

}  // namespace roomcast::hub::federation
