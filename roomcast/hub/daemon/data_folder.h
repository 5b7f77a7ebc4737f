// SPDX-License-Identifier: Apache-2.0
// Where a hub keeps what it keeps on this machine. Threading: no state.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "roomcast/core/result.h"

namespace roomcast::hub::daemon {

/// $XDG_STATE_HOME/roomcast, else ~/.local/state/roomcast, else nothing.
[[nodiscard]] std::optional<std::filesystem::path> default_data_folder();

/// `named`, else the default one.
[[nodiscard]] std::optional<std::filesystem::path> data_folder(const std::string& named);

/// Made where it is missing; nothing where there is no home to have it in. kUnavailable: it cannot
/// be made.
[[nodiscard]] Result<std::optional<std::filesystem::path>> make_data_folder(
    const std::string& named);

/// Can this program write here? Where there is no such folder: could it make one? Nothing is made
/// or written. kUnavailable: no, and why.
[[nodiscard]] Status check_folder(const std::filesystem::path& folder);

}  // namespace roomcast::hub::daemon
