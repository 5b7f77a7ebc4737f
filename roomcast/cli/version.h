// SPDX-License-Identifier: Apache-2.0
// What `roomcast --version` says.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace roomcast::cli {

/// "roomcast 0.1.0 (commit 0123456789ab, wire version 1)"; the commit is "unknown" where the
/// program was built from sources without their history.
[[nodiscard]] std::string version_text();

/// The same, and a line with the kinds of cameras that were built in.
[[nodiscard]] std::string version_text(std::span<const std::string_view> cameras);

}  // namespace roomcast::cli
