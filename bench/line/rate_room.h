// SPDX-License-Identifier: Apache-2.0
// RateRoom: simulated sensors at the near end of an emulated link, a viewer at its far end, and the
// hub at either.
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
  std::size_t small_frames = 0;  // of the small rendition
  double longest_gap_ms = 0;     // between two frames of a sensor on arrival
  struct BestSensor {
    double frames = 0, longest_gap_ms = 0;
  } best_sensor;  // of the one of which most frames came
  double seconds = 0;
};

class RateRoom {
 public:
  using End = EmulatedLink::End;

  /// options.sensors sensors in options.scene, each with this codec; `uplink_mbit` is the room's,
  /// as in hub::RoomSettings. With the hub at the near end the link is the viewer's. kUnsupported:
  /// not root, or no TUN devices; other errors: those of the hub and of the sensors.
  static Result<std::unique_ptr<RateRoom>> open(const LineBenchOptions& options,
                                                const LinkSpec& link,
                                                const sensor::CodecChoice& codec,
                                                double uplink_mbit = 0, End hub_at = End::kFar);

  /// Measures the link and the frames that arrive at the viewer, for this long.
  [[nodiscard]] RateOutcome measure(std::chrono::milliseconds duration);
  /// As measure(), but the viewer is somebody in the middle of the room who turns round by half a
  /// turn every few seconds and tells it.
  [[nodiscard]] Result<RateOutcome> measure_turning(std::chrono::milliseconds duration);
  /// Sensor `number` of options.sensors comes, too.
  [[nodiscard]] Status join_sensor(const LineBenchOptions& options,
                                   const sensor::CodecChoice& codec, int number);
  /// Bytes that each sensor has sent, in the order in which they came.
  [[nodiscard]] std::vector<double> bytes_sent() const;
  /// The link carries so much from now on.
  void set_link_rate(double mbit_per_s) { link_->set_rate(mbit_per_s); }
  /// Nothing passes the link for so long.
  void stop_link_for(std::chrono::milliseconds duration) { link_->stop_for(duration); }

 private:
  explicit RateRoom(std::unique_ptr<EmulatedLink> link) : link_(std::move(link)) {}

  Status open_hub(double uplink_mbit, End end);
  RateOutcome read_line(std::chrono::milliseconds duration);
  [[nodiscard]] bool has_more_to_send() const;

  const std::unique_ptr<EmulatedLink> link_;
  std::unique_ptr<hub::RunningHub> hub_;
  std::unique_ptr<SetWatcher> watcher_;
  std::vector<std::unique_ptr<sensor::SensorFeed>> feeds_;
};

}  // namespace roomcast::bench
