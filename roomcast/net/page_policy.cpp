// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/page_policy.h"

#include <algorithm>
#include <cctype>

namespace roomcast::net {
namespace {

constexpr std::string_view kOwnServer = "connect-src 'self'";
constexpr std::string_view kNoFrames = "frame-ancestors 'none'";
constexpr std::uint16_t kHttpPort = 80, kHttpsPort = 443;

std::string address_of(std::string_view scheme, const HubUrl& server) {
  std::string address = std::string(scheme) + "://" + host_and_port(server);
  std::ranges::transform(address, address.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return address;
}

}  // namespace

std::string page_policy(std::span<const HubUrl> others,
                        std::span<const std::string> embedding_sites) {
  std::string policy(kPagePolicy);
  if (!embedding_sites.empty()) {
    std::string frames = "frame-ancestors";
    for (const std::string& site : embedding_sites) frames += " " + site;
    policy.replace(policy.find(kNoFrames), kNoFrames.size(), frames);
  }
  std::string more;
  for (const HubUrl& other : others) more += " " + address_of(other.tls ? "wss" : "ws", other);
  return policy.insert(policy.find(kOwnServer) + kOwnServer.size(), more);
}

std::string site_of(const HubUrl& server) {
  std::string site = address_of(server.tls ? "https" : "http", server);
  const bool is_usual = server.port == (server.tls ? kHttpsPort : kHttpPort);
  return is_usual ? site.substr(0, site.rfind(':')) : site;
}

}  // namespace roomcast::net
