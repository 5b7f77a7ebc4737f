// SPDX-License-Identifier: Apache-2.0
// ChildProcess: a server under test in a separate process, so that its CPU time and memory can be
// measured alone. The process ends with this object, and with its parent.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

#include "roomcast/core/result.h"

namespace roomcast::bench {

class ChildProcess {
 public:
  /// Runs `serve` in a fork of this program. `serve` calls its argument with its port once it
  /// listens, and returns only to end the process. kUnavailable: no port was reported within 5 s.
  using PortReport = std::function<void(std::uint16_t port)>;
  static Result<ChildProcess> fork_off(const std::function<void(const PortReport&)>& serve);

  /// Runs a program that will listen on `port` and waits until it does. kUnavailable: it does not.
  static Result<ChildProcess> execute(const std::vector<std::string>& command, std::uint16_t port);

  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) = delete;
  ~ChildProcess();

  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// CPU time of all threads of the process so far.
  [[nodiscard]] std::chrono::nanoseconds cpu_time() const;
  /// Resident memory of the process that is not shared, now.
  [[nodiscard]] std::size_t resident_bytes() const;

 private:
  ChildProcess(pid_t pid, std::uint16_t port) : pid_(pid), port_(port) {}

  pid_t pid_;
  std::uint16_t port_;
};

/// A port of 127.0.0.1 that is currently unused.
[[nodiscard]] std::uint16_t free_port();
/// Path of the program of this name in $PATH or where servers are installed; empty: not found.
[[nodiscard]] std::string find_program(const std::string& name);

}  // namespace roomcast::bench
