// SPDX-License-Identifier: Apache-2.0
// A .oni file as a Camera: another process reads it (oni_reader.h), because damaged files crash
// OpenNI. Single-threaded.
#pragma once

#include <memory>
#include <string>

#include "roomcast/core/result.h"
#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

/// kMalformed: the file is damaged. kUnavailable: OpenNI cannot open it, or the program that reads
/// it is missing. The camera's wait() also returns kMalformed.
[[nodiscard]] Result<std::unique_ptr<Camera>> open_oni_file(const std::string& file, bool loop);

}  // namespace roomcast::source
