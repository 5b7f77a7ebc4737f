// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/hub_aligner.h"

#include <array>

#include <fmt/format.h>

#include "roomcast/net/random_bytes.h"

namespace roomcast::cli {

std::string make_aligner_key() {
  std::array<std::uint8_t, 16> bytes{};
  net::fill_with_random_bytes(bytes);
  std::string key;
  for (const std::uint8_t byte : bytes) key += fmt::format("{:02x}", byte);
  return key;
}

std::string own_hub_url(const HubAlignerOptions& options) {
  std::string host = options.listen_address;
  if (host == "0.0.0.0") host = "127.0.0.1";
  if (host == "::") host = "::1";
  if (host.find(':') != std::string::npos) host = "[" + host + "]";
  if (!options.certificate) return fmt::format("ws://{}:{}", host, options.port);
  return fmt::format("wss://{}:{}#sha256={}", host, options.port,
                     net::to_string(*options.certificate));
}

Result<std::unique_ptr<aligner::RoomAligner>> start_hub_aligner(const HubAlignerOptions& options) {
  return aligner::RoomAligner::open(
      {.hub_url = own_hub_url(options), .room = {}, .key = options.key, .log = options.log});
}

}  // namespace roomcast::cli
