// SPDX-License-Identifier: Apache-2.0
// Publisher::Link: a publisher's connection with its hub. It runs on a network thread of its own;
// what both threads use is guarded by its mutex.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

#include <boost/asio/post.hpp>

#include "roomcast/client/frame_sequence.h"
#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/client/publisher.h"
#include "roomcast/client/send_rate.h"
#include "roomcast/client/sensor_messages.h"
#include "roomcast/client/stop_notice.h"
#include "roomcast/client/uplink/uplink_monitor.h"
#include "roomcast/client/voice_sender.h"
#include "roomcast/net/framed_message.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::client {

class Publisher::Link final : public HubLinkEvents {
 public:
  Link(std::vector<net::HubUrl> hubs, PublisherOptions options)
      : options_(std::move(options)),
        link_(network_.io(), std::move(hubs), join_message(options_), *this,
              {.pace = options_.pace}),
        uplink_(network_.io(), {.state = [this] { return link_.line_state(); },
                                .set_pace =
                                    [this](double pace) {
                                      link_.set_pace(std::min(pace, paced_by_hub_.value_or(pace)));
                                    }}) {
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

  Demand demand() const {
    std::lock_guard lock(mutex_);
    return shared_.demand;
  }
  std::shared_ptr<const wire::pb::WatchedFrom> views() const {
    std::lock_guard lock(mutex_);
    return shared_.views;
  }
  bool frames_wanted() const {
    std::lock_guard lock(mutex_);
    return shared_.frames_wanted();
  }
  void set_pace(std::optional<double> payload_bytes_per_s) {
    boost::asio::post(network_.io(), [this, pace = payload_bytes_per_s] {
      paced_by_hub_ = pace;
      link_.set_pace(pace.value_or(kUnlimited));
    });
  }
  void wait_until_wanted(std::chrono::milliseconds patience, const std::stop_token& stop) {
    const StopNotice notice(stop, mutex_, changed_);
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, patience, [&] {
      return shared_.frames_wanted() || shared_.failure || stop.stop_requested();
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
    return Turn{shared_.session, std::exchange(shared_.want_key, false),
                std::exchange(shared_.want_small_key, false), share};
  }

  std::optional<Published> publish(const Turn& turn, const codec::EncodedFrameInfo& info,
                                   HostTime capture_time, net::MessageBuffer message);

  void publish_small(const Turn& turn, const codec::EncodedFrameInfo& info, HostTime capture_time,
                     net::MessageBuffer message);

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
    bool want_key = false, want_small_key = false;
    Demand demand;
    std::shared_ptr<const wire::pb::WatchedFrom> views;  // null: everything is seen
    bool may_speak = false;
    wire::pb::SightingRequest wanted_sightings;
    std::optional<double> depth_scale;
    std::optional<ClockEstimate> clock;
    std::size_t unsent = 0, unsent_bytes = 0;  // frames; the small ones count as bytes only
    std::optional<Error> down;                 // why there is no connection now
    std::optional<Error> failure;              // why the connection ended for good
    PublisherStats stats;

    [[nodiscard]] bool frames_wanted() const { return demand.is_watched && demand.is_seen; }
  };
  static constexpr double kUnlimited = 4e9;  // bytes per second

  struct UnsentFrame {
    net::FramedMessagePtr message;
    bool is_small = false;
  };

  std::optional<wire::FrameHeader> make_header(FrameSequence& sequence, const Turn& turn,
                                               const codec::EncodedFrameInfo& info,
                                               HostTime capture_time);
  void post(const Turn& turn, wire::FrameHeader header, net::MessageBuffer message);
  [[nodiscard]] std::size_t max_frames_waiting() const {
    return options_.estimate_uplink ? 1 : kMaxFramesWaiting;
  }
  void skip_frame();
  void enqueue(std::uint64_t session, UnsentFrame frame);

  PublisherOptions options_;
  // Used by the publishing thread only.
  FrameSequence sequence_, small_sequence_;
  SendRate send_rate_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Shared shared_;
  std::atomic<std::uint64_t> sound_bytes_{0};

  // Used by the network thread only.
  NetworkThread network_;
  std::deque<UnsentFrame> unsent_;
  VoiceSender voice_;
  std::optional<double> paced_by_hub_;  // payload bytes per second
  std::optional<wire::pb::Control> bundle_;
  bool moved_ = false;  // true since the first move
  HubLink link_;
  UplinkMonitor uplink_;
};

}  // namespace roomcast::client
