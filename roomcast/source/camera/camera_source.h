// SPDX-License-Identifier: Apache-2.0
// CameraSource: a camera as a FrameSource. A dedicated thread reads the camera, so that a busy
// sensor program loses whole frames, which are counted, and always gets the newest. A lost camera
// (disconnected or silent) is reopened by its serial number, with growing pauses between attempts;
// the sensor's name and calibration stay. Threading: next() from one thread, health() from any.
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
  /// A camera without pictures for so long counts as lost: not every library reports a loss.
  std::chrono::milliseconds silence{3000};
  /// Exposure and white balance are locked after so many frames, when they have converged.
  std::uint64_t frames_until_lock = 60;
  LogSink log = {};       // called on the camera's thread
  std::string name = {};  // of the sensor; empty: the kind's and the camera's serial number
};

class CameraSource final : public FrameSource {
 public:
  /// Returns the errors of open_camera.
  static Result<std::unique_ptr<FrameSource>> open(std::shared_ptr<CameraBackend> backend,
                                                   const std::string& place,
                                                   CameraSourceOptions options);
  ~CameraSource() override;

  [[nodiscard]] const SensorDescription& description() const override { return description_; }
  [[nodiscard]] SourceHealth health() const override;
  void set_idle(bool is_idle) override { is_idle_ = is_idle; }
  /// Also waits while the camera is lost. Returns false at the end of a file. kMalformed: the file
  /// is damaged.
  [[nodiscard]] Result<bool> next(CapturedFrame& frame, std::stop_token stop) override;

 private:
  /// Passed from the camera's thread to next(); the last one may be without a frame.
  struct Taken {
    CapturedFrame frame;
    bool is_last = false;
    Status end = {};  // of the last one: an error if a file cannot be read further
  };

  CameraSource(std::shared_ptr<CameraBackend> backend, const std::string& place,
               std::unique_ptr<Camera> camera, CameraSourceOptions options);

  void capture(const std::stop_token& stop);
  [[nodiscard]] Status take_pictures();
  void hand_over(CapturedFrame& frame);
  void hand_over_end(Status end);
  void lock_when_converged();
  void wait_for_reconnection(const Status& loss, const std::stop_token& stop);
  [[nodiscard]] Result<bool> after_end() const;
  [[nodiscard]] bool reopen();
  void say(LogLevel level, const std::string& sentence) const;

  const std::shared_ptr<CameraBackend> backend_;
  const CameraSourceOptions options_;
  SensorDescription description_;

  // Used by the camera's thread only.
  std::unique_ptr<Camera> camera_;
  const std::string place_;  // finds the same camera again
  FramePairing pairing_;
  DeviceClock clock_;
  Backoff pace_;
  HostTime last_picture_at_{};
  std::uint64_t frames_since_open_ = 0;
  bool is_locked_ = false;
  bool has_ended_ = false;

  LatestMailbox<Taken> newest_;
  LatestMailbox<CapturedFrame> spare_;  // memory for reuse
  std::atomic<std::uint64_t> unpaired_{0}, losses_{0};
  std::atomic<std::uint64_t> unread_while_idle_{0};
  std::atomic<bool> is_there_{true}, is_idle_{false};
  // Used by the thread that calls next().
  bool reached_end_ = false;
  Status end_;
  std::jthread thread_;  // the last member, because the thread uses all others
};

}  // namespace roomcast::source
