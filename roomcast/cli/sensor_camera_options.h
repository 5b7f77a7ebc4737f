// SPDX-License-Identifier: Apache-2.0
// Camera options of `roomcast sensor`: for several cameras in one room, and for a calibration file.
#pragma once

#include <CLI/CLI.hpp>

#include "roomcast/sensor/source_factory.h"

namespace roomcast::cli {

void add_camera_options(CLI::App& command, sensor::SourceOptions& source);

}  // namespace roomcast::cli
