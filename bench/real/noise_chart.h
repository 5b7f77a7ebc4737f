// SPDX-License-Identifier: Apache-2.0
// A chart of the noise of a rig's sensors by distance, as SVG for a page. Pure.
#pragma once

#include <string>
#include <vector>

#include "bench/real/sensor_condition.h"

namespace roomcast::bench {

/// One line for each sensor; empty without noise.
[[nodiscard]] std::string noise_chart(const std::vector<SensorCondition>& conditions);

}  // namespace roomcast::bench
