// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/openni2/oni_reader.h"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstddef>

#include <poll.h>
#include <unistd.h>

#include "roomcast/source/drivers/openni2/oni_messages.h"
#include "roomcast/source/drivers/openni2/openni2_device.h"
#include "roomcast/source/drivers/openni2/openni2_session.h"

namespace roomcast::source {
namespace {

constexpr std::chrono::milliseconds kReaderPatience{100};
constexpr std::chrono::milliseconds kFileIsOver{500};

/// The writing end of the pipe; after the first failure it writes nothing.
class OniMessageWriter {
 public:
  explicit OniMessageWriter(int out) : out_(out) {}

  void header(OniMessageKind kind, std::size_t bytes, std::int64_t value) {
    const OniMessageHeader header{kind, static_cast<std::uint32_t>(bytes), value};
    write(&header, sizeof(header));
  }
  void write(const void* data, std::size_t size) {
    const auto* next = static_cast<const char*>(data);
    while (size > 0 && is_read_) {
      const ssize_t written = ::write(out_, next, size);
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) {
        is_read_ = false;
        return;
      }
      next += written;
      size -= static_cast<std::size_t>(written);
    }
  }
  [[nodiscard]] bool is_read() {
    pollfd end{.fd = out_, .events = 0, .revents = 0};
    if (::poll(&end, 1, 0) > 0 && (end.revents & POLLERR) != 0) is_read_ = false;
    return is_read_;
  }

 private:
  const int out_;
  bool is_read_ = true;
};

void write_description(const CameraDescription& camera, OniMessageWriter& out) {
  const SensorCalibration& calibration = camera.calibration;
  const OniDescription description{
      .depth = calibration.depth,
      .color = calibration.color,
      .color_from_depth_x_m = calibration.color_from_depth.translation_m.x(),
      .fps = camera.fps,
      .is_registered = calibration.color_is_registered,
      .has_color = camera.has_color};
  out.header(OniMessageKind::kDescription, sizeof(description), 0);
  out.write(&description, sizeof(description));
}

void write_frame(const CapturedFrame& frame, bool has_color, OniMessageWriter& out) {
  const DepthView depth = frame.depth_mm.view();
  const std::size_t depth_bytes = depth.pixel_count() * sizeof(*depth.data);
  const ColorView color = has_color ? frame.color.view() : ColorView{};
  const std::size_t color_bytes = color.pixel_count() * sizeof(Rgb8);
  out.header(OniMessageKind::kFrame, depth_bytes + color_bytes, frame.device_time.count());
  out.write(depth.data, depth_bytes);
  out.write(color.data, color_bytes);
}

/// OpenNI does not report the end of a file; it is known from the lack of pictures.
void write_frames(OpenNi2Device& device, OniMessageWriter& out) {
  const CameraDescription& camera = device.description();
  FramePairing pairing(camera.fps, camera.has_color,
                       [&](CapturedFrame& frame) { write_frame(frame, camera.has_color, out); });
  std::chrono::milliseconds silence{0};
  while (out.is_read()) {
    if (const auto is_depth = device.bell().wait(kReaderPatience)) {
      silence = silence.zero();
      device.take(*is_depth, pairing);
      continue;
    }
    silence += kReaderPatience;
    if (device.plays_once() && silence >= kFileIsOver)
      return out.header(OniMessageKind::kEnd, 0, 0);
  }
}

Status play_file(const std::string& file, bool loop, OniMessageWriter& out) {
  const OpenNi2Session session;
  if (Status status = session.status(); !status) return status;
  OpenNi2Device device({.place = file, .model = {}, .serial = {}});
  if (Status status = device.start(file, loop); !status) return status;
  write_description(device.description(), out);
  write_frames(device, out);
  return {};
}

}  // namespace

void read_oni_file(const std::string& file, bool loop, int out) {
  (void)std::signal(SIGPIPE, SIG_IGN);
  OniMessageWriter writer(out);
  const Status status = play_file(file, loop, writer);
  if (status) return;
  const std::string sentence = status.error().message.substr(0, kMaxOniFaultBytes);
  writer.header(OniMessageKind::kFault, sentence.size(),
                static_cast<std::int64_t>(status.error().code));
  writer.write(sentence.data(), sentence.size());
}

}  // namespace roomcast::source
