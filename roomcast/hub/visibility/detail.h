// SPDX-License-Identifier: Apache-2.0
// Detail: which of a sensor's frames a viewer or a modeler gets.
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/ids.h"

namespace roomcast::hub {

enum class Detail : std::uint8_t {
  kPaused,     // none
  kKeyFrames,  // key frames
  kBaseOnly,   // those of layer 0
  kAll,
};

/// By sensor ID; sensors beyond the end have Detail::kAll.
using SensorDetails = std::vector<Detail>;

[[nodiscard]] inline Detail detail_of(const SensorDetails& details, SensorId sensor) {
  return sensor.value < details.size() ? details[sensor.value] : Detail::kAll;
}

}  // namespace roomcast::hub
