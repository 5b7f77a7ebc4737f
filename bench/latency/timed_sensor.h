// SPDX-License-Identifier: Apache-2.0
// TimedSensor: a sensor that sends frames of a given size at a given rate, each stamped with its
// creation time. The frames cannot be decoded: the class measures transport, not the codec.
// Threading: has a thread of its own; its socket is made in the network namespace of the
// constructing thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast::bench {

struct TimedSensorOptions {
  std::string hub_url;
  std::string name;
  std::size_t frame_bytes = 20'480;
  double fps = 30;
};

class TimedSensor {
 public:
  explicit TimedSensor(const TimedSensorOptions& options);
  ~TimedSensor();

  [[nodiscard]] std::uint64_t frames_sent() const;

 private:
  class Link;
  std::unique_ptr<Link> link_;
};

}  // namespace roomcast::bench
