// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/publisher.h"

#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

#include <boost/asio/post.hpp>

#include "roomcast/client/frame_sequence.h"
#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/client/send_rate.h"
#include "roomcast/client/sensor_messages.h"
#include "roomcast/client/stop_notice.h"
#include "roomcast/client/uplink/uplink_monitor.h"
#include "roomcast/client/voice_sender.h"
#include "roomcast/net/framed_message.h"
#include "roomcast/wire/frame_header.h"
#include "roomcast/wire/limits.h"

namespace roomcast::client {
namespace {

std::uint32_t clock_error_us(nanoseconds error) {
  const auto us = (error.count() + 999) / 1000;
  return us < wire::kClockErrorUnknown ? static_cast<std::uint32_t>(us) : wire::kClockErrorUnknown;
}

}  // namespace

class Publisher::Link final : public HubLinkEvents {
 public:
  Link(std::vector<net::HubUrl> hubs, PublisherOptions options)
      : options_(std::move(options)),
        link_(network_.io(), std::move(hubs), join_message(options_), *this,
              {.pace = options_.pace}),
        uplink_(network_.io(), {.state = [this] { return link_.line_state(); },
                                .set_pace = [this](double pace) { link_.set_pace(pace); }}) {
    link_.start();
    network_.start();
  }
  ~Link() override {
    network_.finish([this] {
      uplink_.finish();
      link_.stop();
    });
  }

  /// Waits until welcomed, or until the first attempt has failed.
  Status wait_for_welcome() {
    const StopNotice notice(options_.stop, mutex_, changed_);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] {
      return shared_.session > 0 || shared_.down || options_.stop.stop_requested();
    });
    if (shared_.session > 0 || (options_.wait_for_hub && !shared_.failure)) return {};
    return shared_.down ? *shared_.down : stopped_waiting();
  }

  bool frames_wanted() const {
    std::lock_guard lock(mutex_);
    return shared_.frames_wanted;
  }
  void wait_until_wanted(std::chrono::milliseconds patience, const std::stop_token& stop) {
    const StopNotice notice(stop, mutex_, changed_);
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [&] {
      return shared_.frames_wanted || shared_.failure || stop.stop_requested();
    });
  }

  std::optional<Turn> next_turn() {
    std::lock_guard lock(mutex_);
    const bool is_ready = shared_.connected && shared_.clock;
    if (!is_ready || shared_.unsent >= max_frames_waiting()) {
      skip_frame();
      if (is_ready) send_rate_.piled_up(SteadyClock().now());
      return std::nullopt;
    }
    send_rate_.flowed(SteadyClock().now());
    const double share = options_.estimate_uplink ? 1 : send_rate_.share();
    return Turn{shared_.session, std::exchange(shared_.want_key, false), share};
  }

  std::optional<Published> publish(const Turn& turn, const codec::EncodedFrameInfo& info,
                                   HostTime capture_time, net::MessageBuffer message);

  void send_bundle(wire::pb::CalibrationBundle bundle) {
    boost::asio::post(network_.io(), [this, bundle = std::move(bundle)]() mutable {
      bundle_.emplace();
      *bundle_->mutable_calibration_bundle() = std::move(bundle);
      link_.send(*bundle_);
    });
  }
  void send(wire::pb::Control message) {
    boost::asio::post(network_.io(), [this, message = std::move(message)] { link_.send(message); });
  }
  bool may_speak() const {
    std::lock_guard lock(mutex_);
    return shared_.connected && shared_.may_speak;
  }
  void say(std::vector<std::uint8_t> opus, bool ends, HostTime first_sample) {
    if (!may_speak()) return;
    boost::asio::post(network_.io(), [this, opus = std::move(opus), ends, first_sample] {
      voice_.say(opus, ends, first_sample);
      link_.wake();
    });
  }
  void report_moved() {
    boost::asio::post(network_.io(), [this] {
      bundle_.reset();
      moved_ = true;
      link_.send(moved_message());
    });
  }

  wire::pb::SightingRequest wanted_sightings() const {
    std::lock_guard lock(mutex_);
    return shared_.connected ? shared_.wanted_sightings : wire::pb::SightingRequest();
  }
  std::optional<double> depth_scale() const {
    std::lock_guard lock(mutex_);
    return shared_.depth_scale;
  }
  std::optional<RoomTime> room_time(HostTime time) const {
    std::lock_guard lock(mutex_);
    if (!shared_.clock) return std::nullopt;
    return shared_.clock->room_time(time);
  }

  std::optional<Uplink> uplink() const {
    if (!options_.estimate_uplink) return std::nullopt;
    Uplink uplink = uplink_.uplink();
    std::lock_guard lock(mutex_);
    uplink.waiting_bytes += shared_.unsent_bytes;
    return uplink;
  }
  std::uint64_t control_bytes() const { return link_.control_bytes() + sound_bytes_; }

  std::optional<Error> failure() const {
    std::lock_guard lock(mutex_);
    return shared_.failure;
  }
  std::optional<Error> problem() const {
    std::lock_guard lock(mutex_);
    return shared_.connected ? std::nullopt : shared_.down;
  }
  PublisherStats stats() const {
    std::lock_guard lock(mutex_);
    PublisherStats stats = shared_.stats;
    stats.frames_waiting = shared_.connected ? shared_.unsent : 0;
    return stats;
  }

  void on_welcome(const wire::pb::Welcome& welcome) override;
  void on_control(const wire::pb::Control& message) override;
  void on_frame(net::MessageBuffer) override {}  // a hub sends no frames to a sensor
  net::FramedMessagePtr next_frame() override;
  void on_clock(const ClockEstimate& estimate) override;
  void on_down(const Error& reason, bool final) override;

 private:
  struct Shared {
    std::uint64_t session = 0;  // counts welcomes
    SensorId sensor{};
    bool connected = false;
    bool want_key = false;
    bool frames_wanted = true;
    bool may_speak = false;
    wire::pb::SightingRequest wanted_sightings;
    std::optional<double> depth_scale;
    std::optional<ClockEstimate> clock;
    std::size_t unsent = 0, unsent_bytes = 0;  // frames
    std::optional<Error> down;                 // why there is no connection now
    std::optional<Error> failure;              // why the connection ended for good
    PublisherStats stats;
  };

  std::optional<wire::FrameHeader> make_header(const Turn& turn,
                                               const codec::EncodedFrameInfo& info,
                                               HostTime capture_time);
  [[nodiscard]] std::size_t max_frames_waiting() const {
    return options_.estimate_uplink ? 1 : kMaxFramesWaiting;
  }
  void skip_frame();
  void enqueue(std::uint64_t session, net::FramedMessagePtr message);

  PublisherOptions options_;
  // Used by the publishing thread only.
  FrameSequence sequence_;
  SendRate send_rate_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Shared shared_;
  std::atomic<std::uint64_t> sound_bytes_{0};

  // Used by the network thread only.
  NetworkThread network_;
  std::deque<net::FramedMessagePtr> unsent_;
  VoiceSender voice_;
  std::optional<wire::pb::Control> bundle_;
  bool moved_ = false;  // true since the first move
  HubLink link_;
  UplinkMonitor uplink_;
};

void Publisher::Link::on_welcome(const wire::pb::Welcome& welcome) {
  if (!welcome.token().empty() && options_.on_token) options_.on_token(welcome.token());
  unsent_.clear();
  voice_.joined();
  // The join has just sent the configured pose again, or the hub has restored a stored one; both
  // may predate the move.
  if (moved_ && (!bundle_ || options_.world_from_depth)) link_.send(moved_message());
  if (bundle_) link_.send(*bundle_);
  if (options_.estimate_uplink) uplink_.start();
  {
    std::lock_guard lock(mutex_);
    ++shared_.session;
    shared_.sensor = SensorId{static_cast<std::uint16_t>(welcome.sensor_id())};
    shared_.connected = true;
    shared_.want_key = true;
    shared_.frames_wanted = true;
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
    if (message.has_key_request()) shared_.want_key = true;
    if (message.has_sighting_request()) shared_.wanted_sightings = message.sighting_request();
    if (message.has_depth_scale()) shared_.depth_scale = message.depth_scale().factor();
    if (!message.has_frame_demand() || options_.send_unwatched) return;
    const bool was_wanted = std::exchange(shared_.frames_wanted, message.frame_demand().wanted());
    if (shared_.frames_wanted && !was_wanted) shared_.want_key = true;  // its viewers are new
  }
  changed_.notify_all();
}

net::FramedMessagePtr Publisher::Link::next_frame() {
  if (auto sound = voice_.next()) {
    sound_bytes_ += sound->size();
    return sound;
  }
  if (unsent_.empty()) return nullptr;
  auto message = std::move(unsent_.front());
  unsent_.pop_front();
  std::lock_guard lock(mutex_);
  --shared_.unsent;
  shared_.unsent_bytes -= message->size();
  ++shared_.stats.frames_sent;
  shared_.stats.bytes_sent += message->size();
  return message;
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
    shared_.frames_wanted = true;
    shared_.down = reason;
    if (final) shared_.failure = reason;
  }
  changed_.notify_all();
  if (is_news && !final && options_.log)
    options_.log(LogLevel::kWarning, reason.message + "; trying again");
}

std::optional<wire::FrameHeader> Publisher::Link::make_header(const Turn& turn,
                                                              const codec::EncodedFrameInfo& info,
                                                              HostTime capture_time) {
  sequence_.enter(turn.session);
  auto header = sequence_.next(info);
  if (!header) return std::nullopt;
  std::lock_guard lock(mutex_);
  if (!shared_.connected || shared_.session != turn.session || !shared_.clock) return std::nullopt;
  header->sensor = shared_.sensor;
  header->capture_time = shared_.clock->room_time(capture_time);
  header->clock_error_us = clock_error_us(shared_.clock->error);
  ++shared_.unsent;
  sequence_.sent(*header);
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
  auto header = fits(message) ? make_header(turn, info, capture_time) : std::nullopt;
  if (!header) {
    std::lock_guard lock(mutex_);
    shared_.want_key = true;  // this frame is lost, and later ones may build on it
    skip_frame();
    return std::nullopt;
  }
  const auto bytes = message.payload();
  header->payload_length = static_cast<std::uint32_t>(bytes.size() - wire::kFrameHeaderBytes);
  wire::write_frame_header(*header, bytes.first<wire::kFrameHeaderBytes>());
  boost::asio::post(network_.io(), [this, session = turn.session,
                                    sealed = net::frame_message(std::move(message))]() mutable {
    enqueue(session, std::move(sealed));
  });
  return Published{header->seq, header->capture_time};
}

void Publisher::Link::enqueue(std::uint64_t session, net::FramedMessagePtr message) {
  {
    std::lock_guard lock(mutex_);
    if (session != shared_.session || !shared_.connected) return;
    shared_.unsent_bytes += message->size();
  }
  unsent_.push_back(std::move(message));
  link_.wake();
}

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

bool Publisher::frames_wanted() const {
  return link_->frames_wanted();
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
