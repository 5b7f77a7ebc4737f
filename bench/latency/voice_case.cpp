// SPDX-License-Identifier: Apache-2.0
// Measures the age of audio packets at a listener whose line is filled by frames.
#include <chrono>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "bench/latency/latency_cases.h"
#include "bench/latency/timed_sensor.h"
#include "bench/link/emulated_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/core/clock.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/net/hub_url.h"
#include "roomcast/net/timer.h"
#include "roomcast/net/websocket_client.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/control.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::bench {

namespace {

using namespace std::chrono_literals;
constexpr auto kPacketInterval = 20ms;
constexpr std::size_t kPayloadBytes = 80;  // 32 kbit/s
constexpr auto kSettling = 3s;
// Frames of three sensors, 2.9 Mbit/s: more than the line carries.
constexpr LinkSpec kThinLine{.mbit_per_s = 2, .round_trip = 50ms};
constexpr int kVoiceSensors = 3;
constexpr double kVoiceSensorFps = 15;
constexpr std::size_t kVoiceFrameBytes = 8'000;

RoomTime room_now() {
  return RoomTime(SteadyClock().now().time_since_epoch());
}

net::FramedMessagePtr join_of_listener() {
  wire::pb::Control join;
  join.mutable_join()->mutable_viewer()->set_hears(true);
  net::MessageBuffer buffer;
  wire::encode_control(join, buffer.appendable());
  return net::frame_message(std::move(buffer));
}

net::FramedMessagePtr spoken_packet(std::uint32_t seq) {
  const wire::AudioHeader header{
      .seq = seq, .capture_time = room_now(), .payload_length = kPayloadBytes};
  std::vector<std::uint8_t> bytes(wire::kAudioHeaderBytes + kPayloadBytes, 0x55);
  wire::write_audio_header(header, std::span(bytes).first<wire::kAudioHeaderBytes>());
  return net::frame_message(net::MessageBuffer(bytes));
}

struct Heard {
  std::vector<double> audio_ages_ms;
  std::size_t frames = 0;
};

/// A viewer that listens, or speaks all the time. Threading: has a thread of its own; its socket is
/// at the end of the link where it was made.
class Voice final : public net::ConnectionHandler, public std::enable_shared_from_this<Voice> {
 public:
  static std::shared_ptr<Voice> enter(const net::HubUrl& hub, bool speaks) {
    auto voice = std::make_shared<Voice>(speaks);
    net::connect(voice->thread_.io(), hub, {}, [voice](auto connection) {
      if (!connection) return;
      voice->connection_ = *connection;
      voice->connection_->start(voice);
    });
    voice->thread_.start();
    return voice;
  }
  explicit Voice(bool speaks) : speaks_(speaks), timer_(thread_.io()) {}

  void leave() {
    thread_.finish([this] {
      timer_.stop();
      if (connection_) connection_->close(net::close_code::kNormal, "");
    });
  }
  Heard take() {
    const std::scoped_lock lock(mutex_);
    return std::exchange(heard_, {});
  }

  void on_message(net::MessageBuffer message) override {
    const auto type = wire::message_type(message.payload());
    if (!type) return;
    const std::scoped_lock lock(mutex_);
    if (*type == wire::MessageType::kFrame) ++heard_.frames;
    if (*type != wire::MessageType::kAudio) return speak_once();
    const auto header = wire::parse_audio(message.payload());
    const std::chrono::duration<double, std::milli> age = room_now() - header->capture_time;
    heard_.audio_ages_ms.push_back(age.count());
  }
  net::FramedMessagePtr next_message() override {
    if (!std::exchange(has_joined_, true)) return join_of_listener();
    return std::exchange(packet_, nullptr);
  }
  void on_closed(const net::CloseReason&) override { timer_.cancel(); }

 private:
  /// Begins to speak at the first message of the hub.
  void speak_once() {
    if (!speaks_ || std::exchange(is_speaking_, true)) return;
    next_packet_at_ = std::chrono::steady_clock::now();
    speak_on();
  }
  void speak_on() {
    next_packet_at_ += kPacketInterval;
    timer_.once(next_packet_at_ - std::chrono::steady_clock::now(), [this] {
      packet_ = spoken_packet(seq_++);
      connection_->wake();
      speak_on();
    });
  }

  const bool speaks_;
  client::NetworkThread thread_;
  std::shared_ptr<net::WebSocketConnection> connection_;
  net::Timer timer_;
  std::chrono::steady_clock::time_point next_packet_at_;
  bool has_joined_ = false, is_speaking_ = false;
  std::uint32_t seq_ = 0;
  net::FramedMessagePtr packet_;
  std::mutex mutex_;
  Heard heard_;  // guarded by mutex_
};

}  // namespace

Status measure_voice(std::chrono::milliseconds duration, LatencyReport& report) {
  auto link = EmulatedLink::open(kThinLine);
  if (!link) return link.error();
  std::unique_ptr<hub::RunningHub> hub;
  std::vector<std::unique_ptr<TimedSensor>> sensors;
  std::shared_ptr<Voice> speaker, listener;
  Status status;
  (*link)->run(EmulatedLink::End::kNear, [&] {
    auto started = hub::RunningHub::start(
        {.address = EmulatedLink::address(EmulatedLink::End::kNear), .port = 0});
    if (!started) return void(status = started.error());
    hub = *std::move(started);
    for (int i = 0; i < kVoiceSensors; ++i) {
      sensors.push_back(std::make_unique<TimedSensor>(TimedSensorOptions{
          hub->url(), "s" + std::to_string(i), kVoiceFrameBytes, kVoiceSensorFps}));
    }
    speaker = Voice::enter(*net::parse_hub_url(hub->url()), true);
  });
  if (!status) return status;
  (*link)->run(EmulatedLink::End::kFar,
               [&] { listener = Voice::enter(*net::parse_hub_url(hub->url()), false); });
  std::this_thread::sleep_for(kSettling);
  (void)listener->take();
  const std::uint64_t before = (*link)->carried_bytes();
  std::this_thread::sleep_for(duration);
  const double carried = static_cast<double>((*link)->carried_bytes() - before);
  Heard heard = listener->take();
  listener->leave();
  speaker->leave();
  if (heard.audio_ages_ms.empty())
    return Error{ErrorCode::kUnavailable, "no audio arrives over the emulated link"};

  const double seconds = std::chrono::duration<double>(duration).count();
  report.figures.push_back(
      {"voice: audio packets delivered", "%",
       100 * static_cast<double>(heard.audio_ages_ms.size()) / (seconds * (1s / kPacketInterval))});
  report.figures.push_back(
      {"voice: frames delivered", "%",
       100 * static_cast<double>(heard.frames) / (seconds * kVoiceSensors * kVoiceSensorFps)});
  report.figures.push_back(
      {"voice: use of the link", "%", 100 * carried / (seconds * kThinLine.mbit_per_s * 1e6 / 8)});
  report.rows.push_back(distribution("voice: audio's age while frames fill the line", "ms",
                                     std::move(heard.audio_ages_ms)));
  return {};
}

}  // namespace roomcast::bench
