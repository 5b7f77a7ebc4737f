// SPDX-License-Identifier: Apache-2.0
#include "bench/latency/timed_sensor.h"

#include <atomic>
#include <chrono>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "bench/latency/hub_address.h"
#include "bench/sensor_fixture.h"
#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/net/timer.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::bench {

class TimedSensor::Link final : public client::HubLinkEvents {
 public:
  explicit Link(const TimedSensorOptions& options)
      : options_(options),
        period_(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
            std::chrono::duration<double>(1 / options.fps))),
        timer_(network_.io()),
        link_(network_.io(), hub_address(options.hub_url),
              sensor_fixture(options.name, options.fps), *this) {
    link_.start();
    network_.start();
  }
  ~Link() override {
    network_.finish([this] {
      timer_.stop();
      link_.stop();
    });
  }

  void on_welcome(const wire::pb::Welcome& welcome) override {
    id_ = SensorId{static_cast<std::uint16_t>(welcome.sensor_id())};
    seq_ = 0;
    next_frame_at_ = std::chrono::steady_clock::now() + period_;
    make_frames();
  }
  void on_control(const wire::pb::Control&) override {}
  void on_frame(net::MessageBuffer) override {}
  void on_clock(const client::ClockEstimate&) override {}
  void on_down(const Error&, bool) override { timer_.cancel(); }
  net::FramedMessagePtr next_frame() override {
    if (frames_.empty()) return nullptr;
    auto frame = std::move(frames_.front());
    frames_.pop_front();
    return frame;
  }

  [[nodiscard]] std::uint64_t frames_sent() const { return frames_sent_; }

 private:
  void make_frames() {
    timer_.once(next_frame_at_ - std::chrono::steady_clock::now(), [this] {
      frames_.push_back(make_frame());
      link_.wake();
      next_frame_at_ += period_;
      make_frames();
    });
  }

  // The hub runs on this machine's clock, so the stamp is exact without clock synchronisation.
  net::FramedMessagePtr make_frame() {
    std::vector<std::uint8_t> bytes(options_.frame_bytes);
    const wire::FrameHeader header{
        .key = true,
        .sensor = id_,
        .seq = seq_,
        .capture_time = RoomTime(SteadyClock().now().time_since_epoch()),
        .base_seq = seq_,
        .payload_length = static_cast<std::uint32_t>(bytes.size() - wire::kFrameHeaderBytes)};
    wire::write_frame_header(header, std::span(bytes).first<wire::kFrameHeaderBytes>());
    ++seq_;
    ++frames_sent_;
    return net::frame_message(net::MessageBuffer(bytes));
  }

  const TimedSensorOptions options_;
  const std::chrono::steady_clock::duration period_;
  std::atomic<std::uint64_t> frames_sent_ = 0;
  SensorId id_{};
  std::uint32_t seq_ = 0;
  std::deque<net::FramedMessagePtr> frames_;
  client::NetworkThread network_;
  net::Timer timer_;
  std::chrono::steady_clock::time_point next_frame_at_;
  client::HubLink link_;
};

TimedSensor::TimedSensor(const TimedSensorOptions& options)
    : link_(std::make_unique<Link>(options)) {}
TimedSensor::~TimedSensor() = default;

std::uint64_t TimedSensor::frames_sent() const {
  return link_->frames_sent();
}

}  // namespace roomcast::bench
