// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/publisher.h"

#include <utility>

#include "roomcast/client/publisher_link.h"
#include "roomcast/wire/limits.h"

namespace roomcast::client {

Publisher::Publisher(std::unique_ptr<Link> link) : link_(std::move(link)) {}
Publisher::~Publisher() = default;

Result<std::unique_ptr<Publisher>> Publisher::open(PublisherOptions options) {
  auto hubs = net::parse_hub_urls(options.hub_url);
  if (!hubs) return hubs.error();
  if (auto status = check_join(options.room, "sensor", options.name, options.credential); !status)
    return status.error();
  auto link = std::make_unique<Link>(std::move(*hubs), std::move(options));
  if (auto status = link->wait_for_welcome(); !status) return status.error();
  return std::unique_ptr<Publisher>(new Publisher(std::move(link)));
}

Publisher::Demand Publisher::demand() const {
  return link_->demand();
}

std::shared_ptr<const wire::pb::WatchedFrom> Publisher::views() const {
  return link_->views();
}
bool Publisher::frames_wanted() const {
  return link_->frames_wanted();
}
void Publisher::set_pace(std::optional<double> payload_bytes_per_s) {
  link_->set_pace(payload_bytes_per_s);
}
void Publisher::wait_until_wanted(std::chrono::milliseconds patience, const std::stop_token& stop) {
  link_->wait_until_wanted(patience, stop);
}

std::optional<Publisher::Turn> Publisher::next_turn() {
  return link_->next_turn();
}

net::MessageBuffer Publisher::begin_frame() {
  net::MessageBuffer message;
  message.appendable().resize(net::MessageBuffer::kHeadroom + wire::kFrameHeaderBytes);
  return message;
}

bool Publisher::fits(const net::MessageBuffer& message) {
  return message.payload().size() <= wire::kMaxFrameBytes;
}

std::optional<Publisher::Published> Publisher::publish(const Turn& turn,
                                                       const codec::EncodedFrameInfo& info,
                                                       HostTime capture_time,
                                                       net::MessageBuffer message) {
  return link_->publish(turn, info, capture_time, std::move(message));
}

void Publisher::publish_small(const Turn& turn, const codec::EncodedFrameInfo& info,
                              HostTime capture_time, net::MessageBuffer message) {
  link_->publish_small(turn, info, capture_time, std::move(message));
}

void Publisher::send_bundle(wire::pb::CalibrationBundle bundle) {
  link_->send_bundle(std::move(bundle));
}

void Publisher::send(wire::pb::Control message) {
  link_->send(std::move(message));
}
bool Publisher::may_speak() const {
  return link_->may_speak();
}
void Publisher::say(std::vector<std::uint8_t> opus, bool ends, HostTime first_sample) {
  link_->say(std::move(opus), ends, first_sample);
}
void Publisher::report_moved() {
  link_->report_moved();
}

wire::pb::SightingRequest Publisher::wanted_sightings() const {
  return link_->wanted_sightings();
}
std::optional<double> Publisher::depth_scale() const {
  return link_->depth_scale();
}
std::optional<RoomTime> Publisher::room_time(HostTime time) const {
  return link_->room_time(time);
}

std::optional<Uplink> Publisher::uplink() const {
  return link_->uplink();
}
std::uint64_t Publisher::control_bytes() const {
  return link_->control_bytes();
}
std::optional<Error> Publisher::failure() const {
  return link_->failure();
}
std::optional<Error> Publisher::problem() const {
  return link_->problem();
}
PublisherStats Publisher::stats() const {
  return link_->stats();
}

}  // namespace roomcast::client
