// SPDX-License-Identifier: Apache-2.0
// A camera driver of your own in one file: any program that writes frames to a pipe becomes a
// sensor of a room. A frame is 320 x 240 depth values (16 bits, little endian, millimetres),
// followed by 320 x 240 pixels of red, green, blue (8 bits each).
//
//   your_grabber | third_party_camera                           prints the frames' middle pixel
//   your_grabber | third_party_camera ws://127.0.0.1:7600       sends the frames to a hub
//
// A driver implements two interfaces of roomcast/source/camera/camera.h: Camera, which delivers
// pictures, and CameraBackend, which lists and opens cameras. CameraSource adds threads, pairing,
// clocks, dropped frames, loss and replug.
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <thread>

#include <poll.h>
#include <unistd.h>

#include "roomcast/sensor/sensor_feed.h"
#include "roomcast/source/camera/camera_source.h"

namespace {

using namespace roomcast;

constexpr int kWidth = 320, kHeight = 240;
constexpr double kFps = 30;

class PipeCamera final : public source::Camera {
 public:
  explicit PipeCamera(int pipe) : pipe_(pipe) {
    description_.serial = "pipe";
    description_.fps = kFps;
    SensorCalibration& cameras = description_.calibration;
    cameras.depth = {kWidth, kHeight, 285, 285, 159.5, 119.5};
    cameras.color = cameras.depth;
    cameras.color_is_registered = true;  // depth and colour share one pixel grid
  }

  [[nodiscard]] const source::CameraDescription& description() const override {
    return description_;
  }

  [[nodiscard]] Status wait(source::FramePairing& pictures,
                            std::chrono::milliseconds patience) override {
    pollfd readable{pipe_, POLLIN, 0};
    if (::poll(&readable, 1, static_cast<int>(patience.count())) == 0) return {};
    unsigned char* const to = reinterpret_cast<unsigned char*>(&frame_) + filled_;
    const ssize_t got = ::read(pipe_, to, sizeof(frame_) - filled_);
    if (got == 0) return Error{ErrorCode::kClosed, "the pipe has ended"};
    if (got < 0) return Error{ErrorCode::kUnavailable, std::strerror(errno)};
    filled_ += static_cast<std::size_t>(got);
    if (filled_ == sizeof(frame_)) hand_over(pictures);
    return {};
  }

 private:
  struct Frame {
    std::array<std::uint16_t, std::size_t{kWidth} * kHeight> depth_mm;
    std::array<Rgb8, std::size_t{kWidth} * kHeight> color;
  };

  void hand_over(source::FramePairing& pictures) {
    filled_ = 0;
    depth_mm_.resize(kWidth, kHeight);
    color_.resize(kWidth, kHeight);
    std::memcpy(depth_mm_.data(), frame_.depth_mm.data(), sizeof(frame_.depth_mm));
    std::memcpy(color_.data(), frame_.color.data(), sizeof(frame_.color));
    const nanoseconds now = SteadyClock().now().time_since_epoch();
    pictures.depth(now, depth_mm_);
    pictures.color(now, color_);
  }

  const int pipe_;
  source::CameraDescription description_;
  Frame frame_;
  std::size_t filled_ = 0;  // bytes of frame_
  DepthImage depth_mm_;
  ColorImage color_;
};

class PipeBackend final : public source::CameraBackend {
 public:
  [[nodiscard]] std::string kind() const override { return "pipe"; }
  [[nodiscard]] std::string library() const override { return "none"; }
  [[nodiscard]] source::CameraAbilities abilities() const override { return {}; }
  [[nodiscard]] Result<std::vector<source::CameraInfo>> list() override {
    return std::vector<source::CameraInfo>{{"stdin", "pictures from a pipe", "pipe"}};
  }
  [[nodiscard]] Result<std::unique_ptr<source::Camera>> open(
      const source::CameraInfo&, const source::CameraSettings&) override {
    return std::unique_ptr<source::Camera>(std::make_unique<PipeCamera>(STDIN_FILENO));
  }
};

int fail(const Error& error) {
  std::fprintf(stderr, "third_party_camera: %s\n", error.message.c_str());
  return 1;
}

int describe(source::FrameSource& source) {
  source::CapturedFrame frame;
  for (;;) {
    const auto more = source.next(frame, {});
    if (!more) return fail(more.error());
    if (!*more) return 0;
    const Rgb8 color = frame.color.at(kWidth / 2, kHeight / 2);
    std::printf("frame %d: in the middle %d mm, red %d green %d blue %d\n",
                static_cast<int>(frame.index), frame.depth_mm.at(kWidth / 2, kHeight / 2), color.r,
                color.g, color.b);
  }
}

int send(std::unique_ptr<source::FrameSource> source, const std::string& hub_url) {
  sensor::SensorFeedOptions options;
  options.hub_url = hub_url;
  const auto feed = sensor::SensorFeed::start(std::move(source), options);
  if (!feed) return fail(feed.error());
  while (!(*feed)->result()) std::this_thread::sleep_for(std::chrono::milliseconds(100));
  const Status ended = *(*feed)->result();
  return ended ? 0 : fail(ended.error());
}

}  // namespace

int main(int argc, char** argv) {
  // A silent pipe is not an unplugged camera, so it may stay silent for long.
  source::CameraSourceOptions options;
  options.silence = std::chrono::hours(24);
  auto source = source::CameraSource::open(std::make_shared<PipeBackend>(), "", options);
  if (!source) return fail(source.error());
  return argc > 1 ? send(*std::move(source), argv[1]) : describe(**source);
}
