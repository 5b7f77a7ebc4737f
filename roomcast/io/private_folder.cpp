// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/private_folder.h"

#include <cerrno>
#include <system_error>

#include <sys/stat.h>
#include <unistd.h>

namespace roomcast::io {

namespace {

constexpr mode_t kOwnerOnly = 0700, kOthers = S_IRWXG | S_IRWXO;

Error cannot_make(const std::filesystem::path& folder, int reason) {
  return {ErrorCode::kUnavailable, "cannot create the folder " + folder.string() + ": " +
                                       std::generic_category().message(reason)};
}

bool is_known_as_ours(const std::filesystem::path& folder,
                      std::initializer_list<std::string_view> signs) {
  std::error_code error;
  const std::filesystem::directory_iterator entries(folder, error);
  if (error) return false;
  bool is_empty = true;
  for (const auto& entry : entries) {
    is_empty = false;
    for (const std::string_view sign : signs) {
      if (entry.path().filename() == sign || entry.path().extension() == sign) return true;
    }
  }
  return is_empty;
}

}  // namespace

Result<bool> make_private_folder(const std::filesystem::path& folder,
                                 std::initializer_list<std::string_view> signs) {
  std::error_code error;
  if (folder.has_parent_path()) std::filesystem::create_directories(folder.parent_path(), error);
  if (error) return cannot_make(folder, error.value());
  if (::mkdir(folder.c_str(), kOwnerOnly) == 0) return false;
  const int reason = errno;
  struct stat status {};
  if (reason != EEXIST || ::stat(folder.c_str(), &status) != 0) return cannot_make(folder, reason);
  if (!S_ISDIR(status.st_mode)) return cannot_make(folder, ENOTDIR);
  const bool is_ours = status.st_uid == ::geteuid() && (status.st_mode & S_IWOTH) == 0;
  if (!is_ours || (status.st_mode & kOthers) == 0 || !is_known_as_ours(folder, signs)) return false;
  return ::chmod(folder.c_str(), kOwnerOnly) == 0;
}

}  // namespace roomcast::io
