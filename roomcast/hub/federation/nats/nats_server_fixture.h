// SPDX-License-Identifier: Apache-2.0
// For tests: a real NATS server on loopback, on a free port, for the object's lifetime.
#pragma once

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "roomcast/core/temporary_folder.h"

namespace roomcast::hub::federation {

class NatsServer {
 public:
  /// `config` is added to its configuration.
  explicit NatsServer(const std::string& config = "", const std::string& port = "-1") {
    std::ofstream(config_file()) << "listen: \"127.0.0.1:" << port << "\"\nlog_file: \""
                                 << log_file() << "\"\n"
                                 << config;
    std::string program = "nats-server", flag = "-c", file = config_file();
    char* arguments[] = {program.data(), flag.data(), file.data(), nullptr};
    std::string path = "PATH=/usr/sbin:/usr/bin:" + std::string(std::getenv("PATH"));
    char* environment[] = {path.data(), nullptr};
    ::posix_spawn(&pid_, "/usr/sbin/nats-server", nullptr, nullptr, arguments, environment);
    for (int tries = 0; tries < 2'000 && !find_port(); ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  ~NatsServer() {
    if (pid_ == 0) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  NatsServer(const NatsServer&) = delete;
  NatsServer& operator=(const NatsServer&) = delete;

  /// Suspends the server: it neither receives nor sends from now on.
  void hang() const { ::kill(pid_, SIGSTOP); }

  [[nodiscard]] static bool is_installed() { return ::access("/usr/sbin/nats-server", X_OK) == 0; }
  [[nodiscard]] const std::string& port() const { return port_; }
  [[nodiscard]] std::string url() const { return "nats://127.0.0.1:" + port_; }

 private:
  [[nodiscard]] std::string config_file() const { return (folder_.path() / "conf").string(); }
  [[nodiscard]] std::string log_file() const { return (folder_.path() / "log").string(); }

  bool find_port() {
    std::ifstream log(log_file());
    const std::string before = "client connections on 127.0.0.1:";
    bool ready = false;
    for (std::string line; std::getline(log, line);) {
      const auto at = line.find(before);
      if (at != std::string::npos) port_ = line.substr(at + before.size());
      ready |= line.find("Server is ready") != std::string::npos;
    }
    return ready;
  }

  TemporaryFolder folder_;
  pid_t pid_ = 0;
  std::string port_;
};

}  // namespace roomcast::hub::federation
