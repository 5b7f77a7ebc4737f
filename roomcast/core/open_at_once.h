// SPDX-License-Identifier: Apache-2.0
// Opens files that people name without waiting: for a named pipe whose other end nobody has opened,
// open(2) waits for ever, also when the program is asked to end. Threading: no state.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>

namespace roomcast {

/// As open(2) with `flags` and O_CLOEXEC; new files have mode 0666 less the umask. A pipe that
/// nobody writes to is an empty file; one that nobody reads is an error (ENXIO). Reading and
/// writing wait as usual.
[[nodiscard]] int open_at_once(const std::filesystem::path& path, int flags);

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using OwnedFile = std::unique_ptr<std::FILE, CloseFile>;

/// As fopen(3), with mode "r", "w" or "a". Null with errno if it cannot be opened.
[[nodiscard]] OwnedFile open_file_at_once(const std::filesystem::path& path, const char* mode);

}  // namespace roomcast
