// SPDX-License-Identifier: Apache-2.0
// The kinds of cameras that roomcast knows, and which of them this program was built with. The only
// place that asks. Thread-safe (no state).
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

struct CameraKind {
  std::string_view name;     // as a SPEC begins
  std::string_view cameras;  // "Kinect v1"
  std::string_view library;
  std::unique_ptr<CameraBackend> (*make)();  // null where this program was built without it
};

[[nodiscard]] const std::vector<CameraKind>& camera_kinds();
/// Null for a name that is none.
[[nodiscard]] const CameraKind* camera_kind(std::string_view name);

}  // namespace roomcast::source
