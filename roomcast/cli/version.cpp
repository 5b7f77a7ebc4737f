// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/version.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "roomcast/cli/commit.h"  // generated
#include "roomcast/wire/frame_header.h"

namespace roomcast::cli {

std::string version_text() {
  return fmt::format("roomcast {} (commit {}, wire version {})", ROOMCAST_VERSION, ROOMCAST_COMMIT,
                     wire::kVersion);
}

std::string version_text(std::span<const std::string_view> cameras) {
  return version_text() + "\ncameras built in: " +
         (cameras.empty() ? "none" : fmt::format("{}", fmt::join(cameras, ", ")));
}

}  // namespace roomcast::cli
