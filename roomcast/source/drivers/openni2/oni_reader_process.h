// SPDX-License-Identifier: Apache-2.0
// The process that reads a .oni file, and the pipe from it. Move-only; its destructor ends the
// process. Single-threaded.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include <sys/types.h>

#include "roomcast/core/result.h"

namespace roomcast::source {

class OniReaderProcess {
 public:
  /// kUnavailable: the program is not installed beside this one, or does not start.
  [[nodiscard]] static Result<OniReaderProcess> start(const std::string& file, bool loop);
  OniReaderProcess(OniReaderProcess&& other) noexcept;
  OniReaderProcess& operator=(OniReaderProcess&&) = delete;
  ~OniReaderProcess();

  /// Whether bytes, or the end, can be read within `patience`.
  [[nodiscard]] bool has_bytes(std::chrono::milliseconds patience) const;
  /// Reads exactly `size` bytes, waiting up to `within` for each part. kMalformed: the process
  /// stopped sending, or ended before, as it does when the file is damaged.
  [[nodiscard]] Status read(void* to, std::size_t size, std::chrono::milliseconds within);

 private:
  OniReaderProcess(pid_t pid, int pipe, std::string file)
      : pid_(pid), pipe_(pipe), file_(std::move(file)) {}
  [[nodiscard]] Status read_some(char*& to, std::size_t& size);
  [[nodiscard]] Error damaged(const std::string& how) const;

  pid_t pid_;
  int pipe_;
  std::string file_;
};

}  // namespace roomcast::source
