// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/version.h"

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "roomcast/cli/commit.h"  // generated
#include "roomcast/source/drivers/camera_kinds.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::cli {

std::string version_text() {
  std::vector<std::string_view> cameras;
  for (const source::CameraKind& kind : source::camera_kinds()) {
    if (kind.make != nullptr) cameras.push_back(kind.name);
  }
  return fmt::format("roomcast {} (commit {}, wire version {})\ncameras built in: {}",
                     ROOMCAST_VERSION, ROOMCAST_COMMIT, wire::kVersion,
                     cameras.empty() ? "none" : fmt::format("{}", fmt::join(cameras, ", ")));
}

}  // namespace roomcast::cli
