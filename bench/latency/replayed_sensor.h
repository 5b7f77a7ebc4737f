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

class ReplayedSensor {
 public:
  static constexpr double kFps = 30;

  /// Simulates `frame_count` frames of `spec`, then joins.
  static Result<std::unique_ptr<ReplayedSensor>> start(const std::string& spec,
                                                       const std::string& hub_url, int frame_count);
  ~ReplayedSensor();

  /// Time from capture to encoded for each frame so far, milliseconds. Ends the replay.
  [[nodiscard]] std::vector<double> finish();

 private:
  ReplayedSensor(FrameLoop frames, Registration registration,
                 std::unique_ptr<codec::FrameEncoder> encoder,
                 std::unique_ptr<client::Publisher> publisher);
  void play(const std::stop_token& stop);
  void send(const source::CapturedFrame& frame, HostTime captured);

  FrameLoop frames_;
  Registration registration_;
  RegisteredColor registered_;
  std::unique_ptr<codec::FrameEncoder> encoder_;
  std::unique_ptr<client::Publisher> publisher_;
  std::vector<double> encoded_ms_;
  std::jthread thread_;
};

}  // namespace roomcast::bench
