// SPDX-License-Identifier: Apache-2.0
// Fixture for tests that need an X11 window: an X server without a screen (Xvfb), on its own
// display.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace roomcast::viewer::xr {

class XServer {
 public:
  /// Empty if Xvfb is not installed.
  static std::optional<XServer> start() {
    int ends[2];
    if (::pipe(ends) != 0) return std::nullopt;
    const std::string number = std::to_string(ends[1]);
    const char* const arguments[] = {"Xvfb",       "-displayfd", number.c_str(), "-screen", "0",
                                     "800x600x24", "-nolisten",  "tcp",          nullptr};
    pid_t pid = 0;
    const int fault = ::posix_spawnp(&pid, "Xvfb", nullptr, nullptr,
                                     const_cast<char* const*>(arguments), environ);
    ::close(ends[1]);
    const std::string display = fault == 0 ? read_line(ends[0]) : "";
    ::close(ends[0]);
    if (fault != 0) return std::nullopt;
    XServer server(pid);
    if (display.empty()) return std::nullopt;
    server.display_ = ":" + display;
    return server;
  }
  ~XServer() {
    if (pid_ == 0) return;
    ::kill(pid_, SIGTERM);
    ::waitpid(pid_, nullptr, 0);
  }
  XServer(XServer&& other) noexcept
      : pid_(std::exchange(other.pid_, 0)), display_(std::move(other.display_)) {}
  XServer& operator=(XServer&&) = delete;

  [[nodiscard]] const std::string& display() const { return display_; }

 private:
  explicit XServer(pid_t pid) : pid_(pid) {}

  static std::string read_line(int file) {
    std::string line;
    for (char letter = 0; ::read(file, &letter, 1) == 1 && letter != '\n';) line += letter;
    return line;
  }

  pid_t pid_;
  std::string display_;
};

}  // namespace roomcast::viewer::xr
