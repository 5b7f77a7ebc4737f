// SPDX-License-Identifier: Apache-2.0
// HubServer: a Room on a port. The room's state and its timer live on the thread that runs it; its
// connections are dealt out among that one and others (Shard). Threading: open() and run() on one
// thread; port() from any.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "roomcast/core/log.h"
#include "roomcast/core/result.h"
#include "roomcast/net/tls/tls_context.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

struct HubOptions {
  std::string address = "127.0.0.1";
  std::uint16_t port = 7600;                         // 0: any free one
  std::shared_ptr<const net::TlsServerContext> tls;  // without it nothing is encrypted
  std::string room = "room";
  std::optional<std::filesystem::path>
      state_file;           // where sensors' ids and poses are kept; without it they are forgotten
  std::string aligner_key;  // who knows it may place sensors; empty: nobody
  std::optional<std::filesystem::path>
      web_directory;  // the page to serve; without it "/" says how to get one
  std::chrono::milliseconds join_within = wire::kJoinDeadline;
  std::size_t threads = 1;  // at least 1; more than cores gain nothing
  LogSink log;              // called from all of them
};

class HubServer {
 public:
  /// Listens at once; clients are served once run() runs. kUnavailable: the port is in use.
  /// kInvalidArgument: not an address. kNotFound: no page in the web directory.
  static Result<std::unique_ptr<HubServer>> open(HubOptions options);
  ~HubServer();

  [[nodiscard]] std::uint16_t port() const;

  /// Serves until `stop` is requested, then closes all connections in good order.
  void run(std::stop_token stop);

 private:
  class Loop;
  explicit HubServer(std::unique_ptr<Loop> loop);
  std::unique_ptr<Loop> loop_;
};

}  // namespace roomcast::hub
