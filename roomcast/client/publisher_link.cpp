// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/publisher_link.h"

#include <utility>

#include "roomcast/wire/limits.h"

namespace roomcast::client {
namespace {

std::uint32_t clock_error_us(nanoseconds error) {
  const auto us = (error.count() + 999) / 1000;
  return us < wire::kClockErrorUnknown ? static_cast<std::uint32_t>(us) : wire::kClockErrorUnknown;
}

Publisher::Demand demand_from(const wire::pb::FrameDemand& message, bool send_always) {
  Publisher::Demand demand{.mbit = message.mbit()};
  if (send_always) return demand;
  demand.is_watched = message.wanted();
  demand.is_seen = !message.unseen();
  demand.base_only = message.base_only();
  demand.small = message.small();
  return demand;
}

}  // namespace

void Publisher::Link::on_welcome(const wire::pb::Welcome& welcome) {
  if (!welcome.token().empty() && options_.on_token) options_.on_token(welcome.token());
  unsent_.clear();
  voice_.joined();
  // The join has just sent the configured pose again, or the hub has restored a stored one; both
  // may predate the move.
  if (moved_ && (!bundle_ || options_.world_from_depth)) link_.send(moved_message());
  if (bundle_) link_.send(*bundle_);
  if (options_.estimate_uplink) uplink_.start();
  if (paced_by_hub_) link_.set_pace(*paced_by_hub_);
  {
    std::lock_guard lock(mutex_);
    ++shared_.session;
    shared_.sensor = SensorId{static_cast<std::uint16_t>(welcome.sensor_id())};
    shared_.connected = true;
    shared_.want_key = true;
    shared_.demand = {};
    shared_.views.reset();
    shared_.may_speak = welcome.may_speak();
    shared_.wanted_sightings.Clear();
    shared_.clock.reset();
    shared_.unsent = shared_.unsent_bytes = 0;
    shared_.down.reset();
  }
  changed_.notify_all();
  if (options_.log)
    options_.log(LogLevel::kInfo,
                 "joined room \"" + welcome.room() + "\" as \"" + options_.name + "\"");
}

void Publisher::Link::on_control(const wire::pb::Control& message) {
  if (message.has_settings_request() && options_.settings && options_.on_settings_request)
    options_.on_settings_request(message.settings_request());
  {
    std::lock_guard lock(mutex_);
    if (message.has_key_request())
      (message.key_request().small() ? shared_.want_small_key : shared_.want_key) = true;
    if (message.has_sighting_request()) shared_.wanted_sightings = message.sighting_request();
    if (message.has_depth_scale()) shared_.depth_scale = message.depth_scale().factor();
    if (message.has_watched_from() && options_.takes_views && !options_.send_unwatched) {
      const bool is_any = message.watched_from().cones_size() > 0;
      shared_.views =
          is_any ? std::make_shared<wire::pb::WatchedFrom>(message.watched_from()) : nullptr;
    }
    if (!message.has_frame_demand()) return;
    const bool was_wanted = shared_.frames_wanted();
    shared_.demand = demand_from(message.frame_demand(), options_.send_unwatched);
    if (shared_.frames_wanted() && !was_wanted) shared_.want_key = true;  // its viewers are new
  }
  changed_.notify_all();
}

net::FramedMessagePtr Publisher::Link::next_frame() {
  if (auto sound = voice_.next()) {
    sound_bytes_ += sound->size();
    return sound;
  }
  if (unsent_.empty()) return nullptr;
  auto [message, is_small] = std::move(unsent_.front());
  unsent_.pop_front();
  std::lock_guard lock(mutex_);
  shared_.unsent_bytes -= message->size();
  shared_.stats.bytes_sent += message->size();
  if (is_small) return std::move(message);
  --shared_.unsent;
  ++shared_.stats.frames_sent;
  return std::move(message);
}

void Publisher::Link::on_clock(const ClockEstimate& estimate) {
  voice_.clock_is(estimate);
  std::lock_guard lock(mutex_);
  shared_.clock = estimate;
}

void Publisher::Link::on_down(const Error& reason, bool final) {
  voice_.lost();
  unsent_.clear();  // they carry an ID that may be invalid on the next connection
  uplink_.stop();
  bool is_news = false;
  {
    std::lock_guard lock(mutex_);
    is_news = std::exchange(shared_.connected, false);
    shared_.demand = {};
    shared_.down = reason;
    if (final) shared_.failure = reason;
  }
  changed_.notify_all();
  if (is_news && !final && options_.log)
    options_.log(LogLevel::kWarning, reason.message + "; trying again");
}

std::optional<wire::FrameHeader> Publisher::Link::make_header(FrameSequence& sequence,
                                                              const Turn& turn,
                                                              const codec::EncodedFrameInfo& info,
                                                              HostTime capture_time) {
  sequence.enter(turn.session);
  auto header = sequence.next(info);
  if (!header) return std::nullopt;
  std::lock_guard lock(mutex_);
  if (!shared_.connected || shared_.session != turn.session || !shared_.clock) return std::nullopt;
  header->sensor = shared_.sensor;
  header->capture_time = shared_.clock->room_time(capture_time);
  header->clock_error_us = clock_error_us(shared_.clock->error);
  sequence.sent(*header);
  return header;
}

/// Under the lock.
void Publisher::Link::skip_frame() {
  ++shared_.stats.frames_skipped;
  if (shared_.connected) sequence_.skip(shared_.session);
}

std::optional<Publisher::Published> Publisher::Link::publish(const Turn& turn,
                                                             const codec::EncodedFrameInfo& info,
                                                             HostTime capture_time,
                                                             net::MessageBuffer message) {
  auto header = fits(message) ? make_header(sequence_, turn, info, capture_time) : std::nullopt;
  std::unique_lock lock(mutex_);
  if (!header) {
    shared_.want_key = true;  // this frame is lost, and later ones may build on it
    skip_frame();
    return std::nullopt;
  }
  ++shared_.unsent;
  lock.unlock();
  post(turn, *header, std::move(message));
  return Published{header->seq, header->capture_time};
}

void Publisher::Link::publish_small(const Turn& turn, const codec::EncodedFrameInfo& info,
                                    HostTime capture_time, net::MessageBuffer message) {
  auto header =
      fits(message) ? make_header(small_sequence_, turn, info, capture_time) : std::nullopt;
  if (!header) {
    std::lock_guard lock(mutex_);
    shared_.want_small_key = true;
    return;
  }
  header->small = true;
  post(turn, *header, std::move(message));
}

/// Completes the message and hands it to the network's thread.
void Publisher::Link::post(const Turn& turn, wire::FrameHeader header, net::MessageBuffer message) {
  const auto bytes = message.payload();
  header.payload_length = static_cast<std::uint32_t>(bytes.size() - wire::kFrameHeaderBytes);
  wire::write_frame_header(header, bytes.first<wire::kFrameHeaderBytes>());
  boost::asio::post(network_.io(), [this, session = turn.session, is_small = header.small,
                                    sealed = net::frame_message(std::move(message))]() mutable {
    enqueue(session, {std::move(sealed), is_small});
  });
}

void Publisher::Link::enqueue(std::uint64_t session, UnsentFrame frame) {
  {
    std::lock_guard lock(mutex_);
    if (session != shared_.session || !shared_.connected) return;
    shared_.unsent_bytes += frame.message->size();
  }
  unsent_.push_back(std::move(frame));
  link_.wake();
}

}  // namespace roomcast::client
