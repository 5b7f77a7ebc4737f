// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/own_hub.h"

#include <utility>

#include <fmt/format.h>

namespace roomcast::hub::daemon {
namespace {

std::string url_of(const OwnHubAddress& hub) {
  std::string host = hub.listen_address;
  if (host == "0.0.0.0") host = "127.0.0.1";
  if (host == "::") host = "::1";
  if (host.find(':') != std::string::npos) host = "[" + host + "]";
  if (!hub.certificate) return fmt::format("ws://{}:{}", host, hub.port);
  return fmt::format("wss://{}:{}#sha256={}", host, hub.port, net::to_string(*hub.certificate));
}

}  // namespace

void OwnHub::opened(OwnHubAddress address, std::string token) {
  const std::lock_guard lock(mutex_);
  address_ = std::move(address);
  token_ = std::move(token);
}

void OwnHub::trust(const net::Fingerprint& certificate) {
  const std::lock_guard lock(mutex_);
  address_.certificate = certificate;
}

OwnHub::Access OwnHub::access() const {
  const std::lock_guard lock(mutex_);
  return {url_of(address_), token_};
}

}  // namespace roomcast::hub::daemon
