// SPDX-License-Identifier: Apache-2.0
// SensorRequests: admins' requests to sensors for other settings that have no answer yet.
// Single-threaded.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/core/ids.h"
#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::hub {

class SensorRequests {
 public:
  static constexpr std::chrono::seconds kPatience{8};
  static constexpr std::size_t kMaxOpen = 64;
  /// kInvalidArgument: the sensor refuses. kUnavailable: there is no answer.
  using Answered = std::function<void(const Status&)>;

  /// The number of the new request; 0: too many are open, and `answered` has been called.
  std::uint32_t open(ConnectionId sensor, HostTime now, Answered answered);
  /// Answers of nobody's requests have no effect.
  void answer(ConnectionId from, const wire::pb::SettingsAnswer& answer);
  void sensor_left(ConnectionId sensor);
  void give_up_before(HostTime now);

 private:
  struct Open {
    ConnectionId sensor;
    std::uint32_t number = 0;
    HostTime until{};
    Answered answered;
  };
  template <class Which>
  void close(Which which, const Status& outcome);

  std::vector<Open> open_;
  std::uint32_t newest_ = 0;
};

}  // namespace roomcast::hub
