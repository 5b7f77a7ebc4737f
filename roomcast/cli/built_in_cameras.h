// SPDX-License-Identifier: Apache-2.0
// The kinds of cameras that this program was built with, for `--version`.
#pragma once

#include <string_view>
#include <vector>

#include "roomcast/source/drivers/camera_kinds.h"

namespace roomcast::cli {

[[nodiscard]] inline std::vector<std::string_view> built_in_cameras() {
  std::vector<std::string_view> cameras;
  for (const source::CameraKind& kind : source::camera_kinds()) {
    if (kind.make != nullptr) cameras.push_back(kind.name);
  }
  return cameras;
}

}  // namespace roomcast::cli
