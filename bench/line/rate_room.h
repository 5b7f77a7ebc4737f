// SPDX-License-Identifier: Apache-2.0
// RateRoom: simulated sensors at the near end of an emulated link, hub and viewer at its far end.
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "bench/latency/set_watcher.h"
#include "bench/line/line_bench.h"
#include "bench/line/line_rate.h"
#include "bench/link/emulated_link.h"
#include "roomcast/core/result.h"
#include "roomcast/hub/server/running_hub.h"
#include "roomcast/sensor/sender/codec_choice.h"
#include "roomcast/sensor/sensor_feed.h"

namespace roomcast::bench {

struct RateOutcome {
  LineRate line;
  std::vector<double> ages_ms;
  double seconds = 0;
};

class RateRoom {
 public:
  /// options.sensors sensors in options.scene, each with this codec. kUnsupported: not root, or no
  /// TUN devices; other errors: those of the hub and of the sensors.
  static Result<std::unique_ptr<RateRoom>> open(const LineBenchOptions& options,
                                                const LinkSpec& link,
                                                const sensor::CodecChoice& codec);

  /// Measures the link and the frames that arrive at the viewer, for this long.
  [[nodiscard]] RateOutcome measure(std::chrono::milliseconds duration);
  /// The link carries so much from now on.
  void set_link_rate(double mbit_per_s) { link_->set_rate(mbit_per_s); }

 private:
  explicit RateRoom(std::unique_ptr<EmulatedLink> link) : link_(std::move(link)) {}

  Status enter_far();
  Status enter_near(const LineBenchOptions& options, const sensor::CodecChoice& codec);

  const std::unique_ptr<EmulatedLink> link_;
  std::unique_ptr<hub::RunningHub> hub_;
  std::unique_ptr<SetWatcher> watcher_;
  std::vector<std::unique_ptr<sensor::SensorFeed>> feeds_;
};

}  // namespace roomcast::bench
