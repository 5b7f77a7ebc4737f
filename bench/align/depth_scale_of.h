// SPDX-License-Identifier: Apache-2.0
// The only place of the benches that asks alignment for a sensor's depth scale.
#pragma once

#include "roomcast/alignment/rig/alignment_report.h"

namespace roomcast::bench {

/// true depth = scale * reading; 1 where alignment estimates no scale.
template <class Report = alignment::SensorReport>
[[nodiscard]] double depth_scale_of(const Report& sensor) {
  if constexpr (requires { sensor.depth_scale; }) {
    return sensor.depth_scale;
  } else if constexpr (requires { sensor.correction.depth_scale; }) {
    return sensor.correction.depth_scale;
  } else {
    return 1;
  }
}

}  // namespace roomcast::bench
