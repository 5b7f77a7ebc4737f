// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/open_at_once.h"

#include <fcntl.h>
#include <unistd.h>

namespace roomcast {
namespace {

constexpr mode_t kNewFile = 0666;

int flags_of(const char* mode) {
  if (mode[0] == 'r') return O_RDONLY;
  return O_WRONLY | O_CREAT | (mode[0] == 'a' ? O_APPEND : O_TRUNC);
}

}  // namespace

int open_at_once(const std::filesystem::path& path, int flags) {
  const int descriptor = ::open(path.c_str(), flags | O_NONBLOCK | O_CLOEXEC, kNewFile);
  if (descriptor >= 0) ::fcntl(descriptor, F_SETFL, flags & O_APPEND);
  return descriptor;
}

OwnedFile open_file_at_once(const std::filesystem::path& path, const char* mode) {
  const int descriptor = open_at_once(path, flags_of(mode));
  if (descriptor < 0) return nullptr;
  OwnedFile file(::fdopen(descriptor, mode));
  if (!file) ::close(descriptor);
  return file;
}

}  // namespace roomcast
