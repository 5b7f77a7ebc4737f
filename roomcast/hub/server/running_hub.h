// SPDX-License-Identifier: Apache-2.0
// For tests and benches: a hub that runs on threads of this process until it is destroyed. Its
// socket is opened in the network namespace of the constructing thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "roomcast/core/result.h"
#include "roomcast/hub/server/hub_server.h"

namespace roomcast::hub {

class RunningHub {
 public:
  /// Uses the port in `options`; 0: any free port.
  static Result<std::unique_ptr<RunningHub>> start(HubOptions options) {
    std::string address = options.address;
    auto server = HubServer::open(std::move(options));
    if (!server) return server.error();
    return std::unique_ptr<RunningHub>(new RunningHub(*std::move(server), std::move(address)));
  }

  /// For tests, where opening cannot fail: on loopback, at `port` instead of the port in `options`.
  explicit RunningHub(HubOptions options = {}, std::uint16_t port = 0)
      : RunningHub(*HubServer::open(at_port(std::move(options), port)), "127.0.0.1") {}

  [[nodiscard]] HubServer& server() const { return *server_; }
  [[nodiscard]] std::uint16_t port() const { return server_->port(); }
  [[nodiscard]] std::string url() const {
    return "ws://" + address_ + ":" + std::to_string(port());
  }

 private:
  RunningHub(std::unique_ptr<HubServer> server, std::string address)
      : server_(std::move(server)),
        address_(std::move(address)),
        thread_([this](const std::stop_token& stop) { server_->run(stop); }) {}

  static HubOptions at_port(HubOptions options, std::uint16_t port) {
    options.port = port;
    return options;
  }

  const std::unique_ptr<HubServer> server_;
  const std::string address_;
  const std::jthread thread_;
};

}  // namespace roomcast::hub
