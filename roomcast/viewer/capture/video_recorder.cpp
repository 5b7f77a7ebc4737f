// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/capture/video_recorder.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace roomcast::viewer {

int FramePace::due(HostTime now) {
  if (!begin_) begin_ = now;
  const std::chrono::duration<double> since = now - *begin_;
  const auto wanted = static_cast<std::int64_t>(since.count() * fps_) + 1;
  const std::int64_t times = std::max<std::int64_t>(0, wanted - written_);
  written_ += times;
  return static_cast<int>(std::min<std::int64_t>(times, VideoRecorder::kLongestStill));
}

VideoRecorder::VideoRecorder(std::unique_ptr<VideoSink> sink)
    : sink_(std::move(sink)), writer_([this] { write_frames(); }) {}

VideoRecorder::~VideoRecorder() {
  static_cast<void>(finish());
}

bool VideoRecorder::wants_frame(HostTime now) {
  times_ = pace_.due(now);
  return times_ > 0;
}

void VideoRecorder::offer(ColorImage picture) {
  auto dropped = waiting_.push({std::move(picture), times_});
  if (dropped) times_behind_ += dropped->times;
}

Status VideoRecorder::finish() {
  if (!writer_.joinable()) return {};
  waiting_.push({});  // an empty picture ends the writing thread
  writer_.join();
  Status finished = sink_->finish();
  return fault_ ? std::move(finished) : std::move(fault_);
}

void VideoRecorder::write_frames() {
  for (;;) {
    const auto frame = waiting_.pop({});
    if (!frame || frame->picture.empty()) return;
    const int times = frame->times + times_behind_.exchange(0);
    for (int i = 0; i < times && !failed_; ++i) {
      if (Status written = sink_->write(frame->picture); !written) {
        fault_ = std::move(written);
        failed_ = true;
      }
    }
  }
}

}  // namespace roomcast::viewer
