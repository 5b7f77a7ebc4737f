// SPDX-License-Identifier: Apache-2.0
// VideoRecorder: keeps what is shown as a video of a steady frame rate. Frames are written on a
// thread of its own; when that falls behind, the oldest waiting ones go, and others are
// shown longer, so that the video's time stays right. Threading: offer() and finish() from one
// thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "roomcast/core/clock.h"
#include "roomcast/core/drop_oldest_queue.h"
#include "roomcast/viewer/capture/video_sink.h"

namespace roomcast::viewer {

/// Which frames of a steady video are due. Pure.
class FramePace {
 public:
  explicit FramePace(int fps) : fps_(fps) {}
  /// How many frames long a picture shown at `now` makes the video: 0 when none is due yet, more
  /// than one after a pause.
  [[nodiscard]] int due(HostTime now);

 private:
  int fps_;
  std::optional<HostTime> begin_;
  std::int64_t written_ = 0;
};

class VideoRecorder {
 public:
  static constexpr int kFps = 30;
  static constexpr std::size_t kMaxWaiting = 8;
  static constexpr int kLongestStill = 10 * kFps;  // a machine that slept does not fill the disk

  explicit VideoRecorder(std::unique_ptr<VideoSink> sink);
  ~VideoRecorder();
  VideoRecorder(const VideoRecorder&) = delete;
  VideoRecorder& operator=(const VideoRecorder&) = delete;

  /// True when the video wants a frame now: then offer() one.
  [[nodiscard]] bool wants_frame(HostTime now);
  /// Of the size of the first.
  void offer(ColorImage picture);

  [[nodiscard]] bool has_failed() const { return failed_; }
  /// Waits for what was offered to be written. The first fault, if there was one.
  Status finish();

 private:
  struct Frame {
    ColorImage picture;
    int times = 1;
  };
  void write_frames();

  std::unique_ptr<VideoSink> sink_;
  FramePace pace_{kFps};
  int times_ = 0;  // of the frame that wants_frame() asked for
  DropOldestQueue<Frame> waiting_{kMaxWaiting};
  std::atomic<int> times_behind_ = 0;  // of frames that had to go
  std::atomic<bool> failed_ = false;
  Status fault_;  // the writing thread's, until it has ended
  std::jthread writer_;
};

}  // namespace roomcast::viewer
