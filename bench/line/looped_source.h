// SPDX-License-Identifier: Apache-2.0
// LoopedSource: a FrameLoop of a simulated sensor as a source in real time.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "bench/latency/frame_loop.h"
#include "roomcast/core/result.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::bench {

class LoopedSource final : public source::FrameSource {
 public:
  /// Captures `frame_count` frames of simulated sensor `index` of `count` in `scene`.
  /// Errors: those of sensor::open_source.
  static Result<std::unique_ptr<LoopedSource>> capture(const std::string& scene, int index,
                                                       int count, double fps, int frame_count);

  /// The time in the scene of the frame that sensor `index` of `count` captures at this time.
  [[nodiscard]] static nanoseconds scene_time(HostTime captured, int index, int count, double fps,
                                              int frame_count);

  /// After so long all sensors show the same again.
  [[nodiscard]] static nanoseconds period(double fps, int frame_count);

  [[nodiscard]] const source::SensorDescription& description() const override {
    return description_;
  }
  [[nodiscard]] Result<bool> next(source::CapturedFrame& frame, std::stop_token stop) override;

 private:
  LoopedSource(source::SensorDescription description, FrameLoop frames, nanoseconds phase)
      : description_(std::move(description)), frames_(std::move(frames)), phase_(phase) {}

  const source::SensorDescription description_;
  const FrameLoop frames_;
  const nanoseconds phase_;     // of this sensor's instants: sensors are not synchronised
  std::int64_t last_tick_ = 0;  // number of the newest instant since the clock's beginning
};

}  // namespace roomcast::bench
