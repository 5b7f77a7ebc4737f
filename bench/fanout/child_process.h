// SPDX-License-Identifier: Apache-2.0
// ChildProcess: a server under test in a process of its own, so that its CPU time and memory are
// its own. It ends with this object, and with its parent.
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
  /// Runs `serve` in a fork of this program. It calls its argument with its port once it listens,
  /// and never returns but to end. kUnavailable: no port came within 5 s.
  using PortReport = std::function<void(std::uint16_t port)>;
  static Result<ChildProcess> fork_off(const std::function<void(const PortReport&)>& serve);

  /// Runs a program that will listen on `port`, and waits until it does. kUnavailable: it does not.
  static Result<ChildProcess> execute(const std::vector<std::string>& command, std::uint16_t port);

  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&& other) = delete;
  ~ChildProcess();

  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// Of all its threads so far.
  [[nodiscard]] std::chrono::nanoseconds cpu_time() const;
  /// What it has of its own in memory now.
  [[nodiscard]] std::size_t resident_bytes() const;

 private:
  ChildProcess(pid_t pid, std::uint16_t port) : pid_(pid), port_(port) {}

  pid_t pid_;
  std::uint16_t port_;
};

/// A port of 127.0.0.1 on which nobody listens just now.
[[nodiscard]] std::uint16_t free_port();
/// Is there a program of this name in $PATH or where servers are installed? Empty: no.
[[nodiscard]] std::string find_program(const std::string& name);

}  // namespace roomcast::bench
