// SPDX-License-Identifier: Apache-2.0
// What `roomcast sensor` can be asked of a camera: options for several cameras in one room, and the
// file of its calibration.
#pragma once

#include <CLI/CLI.hpp>

#include "roomcast/sensor/source_factory.h"

namespace roomcast::cli {

void add_camera_options(CLI::App& command, sensor::SourceOptions& source);

}  // namespace roomcast::cli
