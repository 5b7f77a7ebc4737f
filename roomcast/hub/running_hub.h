// SPDX-License-Identifier: Apache-2.0
// For tests: a hub on loopback, on a thread of its own while it is held.
#pragma once

#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "roomcast/hub/hub_server.h"

namespace roomcast::hub {

class RunningHub {
 public:
  /// Port 0 is a free one; that of `options` does not count.
  explicit RunningHub(HubOptions options = {}, std::uint16_t port = 0) {
    options.port = port;
    server_ = *HubServer::open(std::move(options));
    thread_ = std::jthread([this](const std::stop_token& stop) { server_->run(stop); });
  }

  [[nodiscard]] HubServer& server() const { return *server_; }
  [[nodiscard]] std::uint16_t port() const { return server_->port(); }
  [[nodiscard]] std::string url() const { return "ws://127.0.0.1:" + std::to_string(port()); }

 private:
  std::unique_ptr<HubServer> server_;
  std::jthread thread_;
};

}  // namespace roomcast::hub
