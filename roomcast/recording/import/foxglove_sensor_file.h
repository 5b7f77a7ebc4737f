// SPDX-License-Identifier: Apache-2.0
// FoxgloveSensorFile: one camera in a recording of Foxglove's schemas. Sensors of the same
// recording share its store, so all of them are used by one thread. Single-threaded.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "roomcast/recording/import/foxglove_streams.h"
#include "roomcast/recording/import/sensor_file.h"

namespace roomcast::recording {

struct FoxgloveCameraParts {
  SensorFileInfo info;
  FoxgloveStream depth;
  std::optional<FoxgloveStream> color;
  std::vector<std::optional<std::size_t>> color_of_depth;  // position in `color`
};

/// `name`: of the file, for messages.
[[nodiscard]] std::unique_ptr<SensorFile> make_foxglove_sensor(std::shared_ptr<MessageStore> store,
                                                               FoxgloveCameraParts parts,
                                                               std::string name);

}  // namespace roomcast::recording
