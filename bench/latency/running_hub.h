// SPDX-License-Identifier: Apache-2.0
// RunningHub: a hub on a free port, on threads of this process, while it is held. Its socket is
// made on the constructing thread's network.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <thread>

#include "roomcast/core/result.h"
#include "roomcast/hub/hub_server.h"

namespace roomcast::bench {

class RunningHub {
 public:
  static Result<std::unique_ptr<RunningHub>> start(const std::string& address) {
    hub::HubOptions options;
    options.address = address;
    options.port = 0;
    auto server = hub::HubServer::open(std::move(options));
    if (!server) return server.error();
    return std::unique_ptr<RunningHub>(new RunningHub(*std::move(server), address));
  }

  [[nodiscard]] std::string url() const {
    return "ws://" + address_ + ":" + std::to_string(server_->port());
  }

 private:
  RunningHub(std::unique_ptr<hub::HubServer> server, std::string address)
      : server_(std::move(server)),
        address_(std::move(address)),
        thread_([this](const std::stop_token& stop) { server_->run(stop); }) {}

  std::unique_ptr<hub::HubServer> server_;
  const std::string address_;
  std::jthread thread_;
};

}  // namespace roomcast::bench
