// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/access/hub_secret.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <span>
#include <string>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "roomcast/net/random_bytes.h"

namespace roomcast::hub {

namespace {

constexpr mode_t kOwnerOnly = 0600;

class File {
 public:
  File(const std::filesystem::path& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, kOwnerOnly)) {
  }
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  [[nodiscard]] int get() const { return descriptor_; }

 private:
  int descriptor_;
};

Error unavailable(const std::filesystem::path& file, const char* what) {
  return {ErrorCode::kUnavailable, std::string("cannot ") + what + " the hub's secret " +
                                       file.string() + ": " + std::strerror(errno)};
}

Result<HubSecret> read_secret(const std::filesystem::path& path) {
  const File file(path, O_RDONLY);
  struct stat status {};
  if (file.get() < 0 || ::fstat(file.get(), &status) != 0) return unavailable(path, "read");
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    return Error{ErrorCode::kInvalidArgument,
                 "others may read the hub's secret: run chmod 600 " + path.string()};
  }
  HubSecret secret{};
  const bool is_whole =
      status.st_size == static_cast<off_t>(secret.size()) &&
      ::read(file.get(), secret.data(), secret.size()) == static_cast<ssize_t>(secret.size());
  // Zeros are what a file system leaves of a file that was being written when the power failed.
  const bool is_random = std::ranges::any_of(secret, [](auto byte) { return byte != 0; });
  if (!is_whole || !is_random) {
    return Error{ErrorCode::kMalformed,
                 path.string() + " is not a hub's secret; delete it, and all tokens with it"};
  }
  return secret;
}

/// Writes a temporary file and links it, so that a reader finds all of the secret or none, also
/// after a crash.
Status write_secret(const std::filesystem::path& path, const HubSecret& secret) {
  const std::filesystem::path draft = path.string() + "." + std::to_string(::getpid());
  {
    ::unlink(draft.c_str());
    const File file(draft, O_WRONLY | O_CREAT | O_EXCL);
    const bool written =
        file.get() >= 0 &&
        ::write(file.get(), secret.data(), secret.size()) == static_cast<ssize_t>(secret.size()) &&
        ::fsync(file.get()) == 0;
    if (!written) return unavailable(path, "write");
  }
  const bool linked = ::link(draft.c_str(), path.c_str()) == 0 || errno == EEXIST;
  const int reason = errno;
  ::unlink(draft.c_str());
  errno = reason;
  if (!linked) return unavailable(path, "write");
  return {};
}

bool is_there(const std::filesystem::path& file) {
  std::error_code absent;
  return std::filesystem::exists(std::filesystem::symlink_status(file, absent));
}

}  // namespace

HubSecret make_hub_secret() {
  HubSecret secret{};
  net::fill_with_random_bytes(secret);
  return secret;
}

std::filesystem::path secret_file_in(const std::filesystem::path& folder) {
  return folder / "hub.secret";
}

Status check_hub_secret(const std::filesystem::path& file) {
  if (!is_there(file)) return {};
  const auto secret = read_secret(file);
  return secret ? Status() : secret.error();
}

Result<HubSecret> find_hub_secret(const std::filesystem::path& file) {
  if (!is_there(file)) {
    if (auto status = write_secret(file, make_hub_secret()); !status) return status.error();
  }
  return read_secret(file);  // if two hubs start at once, both use the secret that was linked first
}

}  // namespace roomcast::hub
