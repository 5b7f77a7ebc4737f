// SPDX-License-Identifier: Apache-2.0
// The sensors whose pictures tell how old what a viewer sees is: three replayed ones, of which the
// first draws the time of capture into its pictures (capture_clock.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "bench/latency/replayed_sensor.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

/// They join the room of this hub; the first one draws the time.
[[nodiscard]] Result<std::vector<std::unique_ptr<ReplayedSensor>>> start_clock_sensors(
    const std::string& hub_url);

/// For a program that watches: where to stand, where to look, and the places on the rays of the
/// code's squares, row by row; in the world, as JSON.
[[nodiscard]] std::string clock_view_json(const source::SensorDescription& clock_sensor);

}  // namespace roomcast::bench
