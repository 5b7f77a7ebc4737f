// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/data_folder.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include <unistd.h>

#include "roomcast/io/private_folder.h"

namespace roomcast::hub::daemon {

namespace fs = std::filesystem;

std::optional<fs::path> default_data_folder() {
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state == '/') {
    return fs::path(state) / "roomcast";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    return fs::path(home) / ".local" / "state" / "roomcast";
  }
  return std::nullopt;
}

std::optional<fs::path> data_folder(const std::string& named) {
  return named.empty() ? default_data_folder() : std::optional<fs::path>(named);
}

Result<std::optional<fs::path>> make_data_folder(const std::string& named, const LogSink& log) {
  const auto folder = data_folder(named);
  if (!folder) return folder;
  const auto was_open =
      io::make_private_folder(*folder, {"hub.sqlite", "hub.secret", "recordings"});
  if (!was_open) {
    return Error{ErrorCode::kUnavailable, was_open.error().message + "; name another with --data"};
  }
  if (*was_open && log) {
    log(LogLevel::kWarning, "other users of this machine could read " + folder->string() +
                                ", with the hub's recordings; it is closed to them now");
  }
  return folder;
}

Status check_folder(const fs::path& folder) {
  std::error_code error;
  fs::path there = fs::absolute(folder, error);
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  const auto unusable = [&](const std::string& why) {
    return Error{ErrorCode::kUnavailable,
                 "cannot use the folder " + folder.string() + ": " + there.string() + " " + why};
  };
  if (!fs::is_directory(there, error)) return unusable("is no folder");
  if (::access(there.c_str(), R_OK | W_OK | X_OK) == 0) return {};
  return unusable(std::string("is not accessible to this user: ") + std::strerror(errno));
}

}  // namespace roomcast::hub::daemon
