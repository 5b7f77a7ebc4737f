// SPDX-License-Identifier: Apache-2.0
// CameraSource: a camera as a FrameSource. A thread of its own takes pictures from the camera, so
// that a busy sensor program loses whole frames, counted, and always gets the newest. A camera that
// is lost (unplugged, or silent) is waited for with growing pauses and opened again by its serial
// number; the sensor's name and calibration stay. Threading: next() from one thread, health() from
// any.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include "roomcast/core/backoff.h"
#include "roomcast/core/latest_mailbox.h"
#include "roomcast/core/log.h"
#include "roomcast/source/camera/camera.h"
#include "roomcast/source/camera/device_clock.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::source {

struct CameraSourceOptions {
  CameraSettings settings = {};
  /// A camera that gives nothing for so long counts as lost: not every library notices.
  std::chrono::milliseconds silence{3000};
  /// Exposure and white balance are locked after so many frames: until then they settle.
  std::uint64_t frames_until_lock = 60;
  LogSink log = {};  // called from the camera's thread
};

class CameraSource final : public FrameSource {
 public:
  /// Errors of open_camera.
  static Result<std::unique_ptr<FrameSource>> open(std::shared_ptr<CameraBackend> backend,
                                                   const std::string& place,
                                                   CameraSourceOptions options);
  ~CameraSource() override;

  [[nodiscard]] const SensorDescription& description() const override { return description_; }
  [[nodiscard]] SourceHealth health() const override;
  /// Waits while the camera is away, too. False at the end of a file.
  [[nodiscard]] Result<bool> next(CapturedFrame& frame, std::stop_token stop) override;

 private:
  /// What the camera's thread hands over; the last one may come without a frame.
  struct Taken {
    CapturedFrame frame;
    bool is_last = false;
  };

  CameraSource(std::shared_ptr<CameraBackend> backend, const std::string& place,
               std::unique_ptr<Camera> camera, CameraSourceOptions options);

  void capture(const std::stop_token& stop);
  [[nodiscard]] Status take_pictures();
  void hand_over(CapturedFrame& frame);
  void hand_over_end();
  void lock_when_settled();
  void wait_for_return(const Status& loss, const std::stop_token& stop);
  [[nodiscard]] bool reopen();
  void say(LogLevel level, const std::string& sentence) const;

  const std::shared_ptr<CameraBackend> backend_;
  const CameraSourceOptions options_;
  SensorDescription description_;

  // Of the camera's thread.
  std::unique_ptr<Camera> camera_;
  const std::string place_;  // of this very camera
  FramePairing pairing_;
  DeviceClock clock_;
  Backoff pace_;
  HostTime last_heard_{};
  std::uint64_t frames_since_open_ = 0;
  bool is_locked_ = false;
  bool has_ended_ = false;

  LatestMailbox<Taken> newest_;
  LatestMailbox<CapturedFrame> spare_;  // memory to fill again
  std::atomic<std::uint64_t> unpaired_{0}, losses_{0};
  std::atomic<bool> is_there_{true};
  bool reached_end_ = false;  // of the thread that calls next()
  std::jthread thread_;       // the last member: it uses all others
};

}  // namespace roomcast::source
