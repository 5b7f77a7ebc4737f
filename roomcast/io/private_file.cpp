// SPDX-License-Identifier: Apache-2.0
#include "roomcast/io/private_file.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace roomcast::io {
namespace {

constexpr mode_t kPrivateFileMode = 0600;

Error cannot_create(const std::filesystem::path& file, int reason) {
  return {ErrorCode::kUnavailable,
          "cannot write " + file.string() + ": " + std::generic_category().message(reason)};
}

int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

}  // namespace

Status write_private_file(const std::filesystem::path& file, std::string_view text) {
  const int descriptor =
      ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kPrivateFileMode);
  if (descriptor < 0) return cannot_create(file, errno);
  int failure = write_all(descriptor, text);
  if (::close(descriptor) != 0 && failure == 0) failure = errno;
  if (failure == 0) return {};
  ::unlink(file.c_str());
  return cannot_create(file, failure);
}

}  // namespace roomcast::io
