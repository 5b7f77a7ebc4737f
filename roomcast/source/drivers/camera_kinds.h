// SPDX-License-Identifier: Apache-2.0
// The kinds of cameras known to roomcast, and the subset that this program was built with. Only
// this unit depends on those build options. Thread-safe (no state).
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/source/camera/camera.h"

namespace roomcast::source {

struct CameraKind {
  std::string_view name;     // first part of a SPEC
  std::string_view cameras;  // "Kinect v1"
  std::string_view library;
  std::unique_ptr<CameraBackend> (*make)();  // null if this program was built without it
};

[[nodiscard]] const std::vector<CameraKind>& camera_kinds();
/// Null for an unknown name.
[[nodiscard]] const CameraKind* camera_kind(std::string_view name);

}  // namespace roomcast::source
