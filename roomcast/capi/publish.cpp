// SPDX-License-Identifier: Apache-2.0
// The functions of roomcast.h by which a program is a sensor.
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "roomcast/capi/c_border.h"
#include "roomcast/capi/roomcast.h"
#include "roomcast/capi/sensor_options.h"
#include "roomcast/sensor/sender/frame_sender.h"

struct roomcast_publisher {
  roomcast::SensorCalibration calibration;  // unchanging
  std::mutex mutex;                         // one frame at a time
  std::unique_ptr<roomcast::sensor::FrameSender> sender;
};

namespace {

using namespace roomcast;

using Published = client::Publisher::Published;

void fill(const roomcast_publisher& publisher, const std::optional<Published>& published,
          roomcast_send_report* report) {
  if (report == nullptr) return;
  const client::PublisherStats stats = publisher.sender->publisher().stats();
  roomcast_send_report out{};
  out.sent = published ? 1 : 0;
  out.connected = publisher.sender->publisher().problem() ? 0 : 1;
  out.frames_waiting = static_cast<std::uint32_t>(stats.frames_waiting);
  out.max_frames_waiting = client::Publisher::kMaxFramesWaiting;
  if (published) {
    out.seq = published->seq;
    out.capture_ns = published->capture_time.time_since_epoch().count();
  }
  out.frames_sent = stats.frames_sent;
  out.frames_skipped = stats.frames_skipped;
  out.bytes_sent = stats.bytes_sent;
  out.rate_share = publisher.sender->rate_share();
  capi::copy_known_part(out, *report);
}

Result<std::optional<Published>> send(roomcast_publisher& publisher,
                                      const roomcast_capture* capture) {
  const auto frame = capi::given_frame(capture, publisher.calibration, SteadyClock().now());
  if (!frame) return frame.error();
  if (const auto failure = publisher.sender->publisher().failure()) return *failure;
  return publisher.sender->send(frame->depth_mm, frame->color, frame->capture_time);
}

Result<std::unique_ptr<roomcast_publisher>> publish(const roomcast_options* options,
                                                    const roomcast_sensor_options* sensor) {
  auto joining = capi::publisher_options(options, sensor);
  if (!joining) return joining.error();
  const auto codec = capi::codec_choice(sensor);
  if (!codec) return codec.error();
  auto publisher = std::make_unique<roomcast_publisher>();
  publisher->calibration = joining->calibration;
  auto sender = sensor::FrameSender::open(*std::move(joining), *codec);
  if (!sender) return sender.error();
  publisher->sender = *std::move(sender);
  return publisher;
}

}  // namespace

extern "C" {

int64_t roomcast_host_time_ns(void) {
  return SteadyClock().now().time_since_epoch().count();
}

roomcast_publisher* roomcast_publish(const roomcast_options* options,
                                     const roomcast_sensor_options* sensor, char* error,
                                     size_t error_size) {
  return capi::guarded<roomcast_publisher*>(
      nullptr, error, error_size, [&]() -> roomcast_publisher* {
        auto publisher = publish(options, sensor);
        if (publisher) return publisher->release();
        capi::say(publisher.error().message, error, error_size);
        return nullptr;
      });
}

int roomcast_send_frame(roomcast_publisher* publisher, const roomcast_capture* capture,
                        roomcast_send_report* report, char* error, size_t error_size) {
  return capi::guarded(0, error, error_size, [&] {
    if (publisher == nullptr) {
      capi::say("publisher is NULL", error, error_size);
      return 0;
    }
    const std::lock_guard lock(publisher->mutex);
    const auto sent = send(*publisher, capture);
    fill(*publisher, sent ? *sent : std::nullopt, report);
    if (!sent) capi::say(sent.error().message, error, error_size);
    return sent ? 1 : 0;
  });
}

int roomcast_is_publishing(roomcast_publisher* publisher, char* error, size_t error_size) {
  return capi::guarded(0, error, error_size, [&] {
    if (publisher == nullptr) {
      capi::say("publisher is NULL", error, error_size);
      return 0;
    }
    const auto problem = publisher->sender->publisher().problem();
    if (problem) capi::say(problem->message, error, error_size);
    return problem ? 0 : 1;
  });
}

void roomcast_stop_publishing(roomcast_publisher* publisher) {
  delete publisher;
}

}  // extern "C"
