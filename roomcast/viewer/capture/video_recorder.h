// SPDX-License-Identifier: Apache-2.0
// VideoRecorder: records the shown pictures as a video with a constant frame rate. A thread of its
// own writes the frames; when it falls behind, the oldest waiting frames are dropped and others
// repeated, so that the video keeps real time. Threading: offer() and finish() from one thread.
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

/// Decides which frames of a constant-rate video are due. Pure.
class FramePace {
 public:
  explicit FramePace(int fps) : fps_(fps) {}
  /// The number of video frames to fill with a picture shown at `now`: 0 if none is due yet, more
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
  static constexpr int kLongestStill = 10 * kFps;  // frames; limits the gap after a suspension

  explicit VideoRecorder(std::unique_ptr<VideoSink> sink);
  ~VideoRecorder();
  VideoRecorder(const VideoRecorder&) = delete;
  VideoRecorder& operator=(const VideoRecorder&) = delete;

  /// True if the video needs a frame now; then call offer().
  [[nodiscard]] bool wants_frame(HostTime now);
  /// All pictures must have the size of the first.
  void offer(ColorImage picture);

  [[nodiscard]] bool has_failed() const { return failed_; }
  /// Waits until all offered frames are written. Returns the first error, if any.
  Status finish();

 private:
  struct Frame {
    ColorImage picture;
    int times = 1;
  };
  void write_frames();

  std::unique_ptr<VideoSink> sink_;
  FramePace pace_{kFps};
  int times_ = 0;  // repetitions of the frame requested by wants_frame()
  DropOldestQueue<Frame> waiting_{kMaxWaiting};
  std::atomic<int> times_behind_ = 0;  // repetitions owed for dropped frames
  std::atomic<bool> failed_ = false;
  Status fault_;  // owned by the writing thread until it has ended
  std::jthread writer_;
};

}  // namespace roomcast::viewer
