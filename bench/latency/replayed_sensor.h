// SPDX-License-Identifier: Apache-2.0
// ReplayedSensor: a few seconds of a simulated sensor, made beforehand and played forward and
// backward in real time, so that the simulator's cost is not measured. Registers, encodes and
// publishes as `roomcast sensor` does. Threading: has a thread of its own.
#pragma once

#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "bench/latency/frame_loop.h"
#include "roomcast/client/publisher.h"
#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/result.h"
#include "roomcast/geometry/registration.h"
#include "roomcast/source/frame_source.h"

namespace roomcast::bench {

struct ReplayOptions {
  int frame_count = 45;
  double fps = 30;
  bool draws_clock = false;  // the time of capture, into the pictures (capture_clock.h)
};

class ReplayedSensor {
 public:
  /// Simulates frames of `spec`, then joins.
  static Result<std::unique_ptr<ReplayedSensor>> start(const std::string& spec,
                                                       const std::string& hub_url,
                                                       const ReplayOptions& options);
  ~ReplayedSensor();

  [[nodiscard]] const source::SensorDescription& description() const { return description_; }
  /// Time from capture to encoded for each frame so far, milliseconds. Ends the replay.
  [[nodiscard]] std::vector<double> finish();

 private:
  ReplayedSensor(source::SensorDescription description, const ReplayOptions& options,
                 FrameLoop frames, Registration registration,
                 std::unique_ptr<codec::FrameEncoder> encoder,
                 std::unique_ptr<client::Publisher> publisher);
  void play(const std::stop_token& stop);
  void send(const source::CapturedFrame& frame, HostTime captured);

  const source::SensorDescription description_;
  const ReplayOptions options_;
  FrameLoop frames_;
  Registration registration_;
  RegisteredColor registered_;
  std::unique_ptr<codec::FrameEncoder> encoder_;
  std::unique_ptr<client::Publisher> publisher_;
  std::vector<double> encoded_ms_;
  std::jthread thread_;
};

}  // namespace roomcast::bench
