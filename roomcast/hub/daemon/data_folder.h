// SPDX-License-Identifier: Apache-2.0
// The folder of a hub's persistent data on this machine. Threading: no state.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"

namespace roomcast::hub::daemon {

/// $XDG_STATE_HOME/roomcast, else ~/.local/state/roomcast; nothing: without an absolute
/// XDG_STATE_HOME or HOME.
[[nodiscard]] std::optional<std::filesystem::path> default_data_folder();

/// `named`, or the default folder if it is empty.
[[nodiscard]] std::optional<std::filesystem::path> data_folder(const std::string& named);

/// The data folder, created if missing and closed to other users, which `log` is told where it was
/// open; nothing: there is no home folder. kUnavailable: it cannot be created.
[[nodiscard]] Result<std::optional<std::filesystem::path>> make_data_folder(
    const std::string& named, const LogSink& log);

/// Checks that this program can write in the folder, or could create it. Changes nothing.
/// kUnavailable: it cannot; the message gives the reason.
[[nodiscard]] Status check_folder(const std::filesystem::path& folder);

}  // namespace roomcast::hub::daemon
