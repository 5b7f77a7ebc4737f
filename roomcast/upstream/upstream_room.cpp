// SPDX-License-Identifier: Apache-2.0
#include "roomcast/upstream/upstream_room.h"

#include <random>
#include <utility>

namespace roomcast::upstream {

namespace pb = wire::pb;

UpstreamRoom::UpstreamRoom(boost::asio::io_context& io, const UpstreamOptions& options,
                           const std::string& room, MirroredRoom mirror)
    : io_(io),
      options_(options),
      room_(room),
      mirror_(std::move(mirror)),
      pace_(std::random_device{}()),
      timer_(io) {
  connect();
}

UpstreamRoom::~UpstreamRoom() {
  timer_.cancel();
}

void UpstreamRoom::connect() {
  pb::Join join;
  join.set_room(room_);
  join.set_name("hub");
  show(options_.credential, join);
  join.mutable_viewer();
  HubLinkEvents& events = *this;
  link_.emplace(io_, options_.hubs[hub_], std::move(join), events, kTimings);
  link_->start();
}

void UpstreamRoom::said(ConnectionId to, const pb::Control& message) {
  if (const auto answer = mirror_.said(to, message); answer && link_) link_->send(*answer);
}

void UpstreamRoom::on_welcome(const pb::Welcome&) {
  failures_ = 0;
  pace_.succeeded();
}

void UpstreamRoom::on_control(const pb::Control& message) {
  if (message.has_roster()) mirror_.roster(message.roster());
}

void UpstreamRoom::on_frame(net::MessageBuffer message) {
  mirror_.frame(std::move(message));
}

void UpstreamRoom::on_clock(const ClockEstimate& estimate) {
  mirror_.clock_is(estimate);
}

void UpstreamRoom::on_down(const Error& reason, bool) {
  link_->stop();
  mirror_.other_hub_is_gone();
  if (failures_++ == 0 && options_.log) {
    options_.log(LogLevel::kWarning,
                 "room \"" + room_ + "\" of " + options_.hubs[hub_].host + ": " + reason.message);
  }
  connect_to_next();
}

/// At once, unless all of them have failed in a row.
void UpstreamRoom::connect_to_next() {
  hub_ = (hub_ + 1) % options_.hubs.size();
  const bool all_failed = failures_ >= options_.hubs.size();
  timer_.expires_after(all_failed ? pace_.next() : nanoseconds(0));
  timer_.async_wait([this](boost::system::error_code error) {
    if (!error) connect();
  });
}

}  // namespace roomcast::upstream
