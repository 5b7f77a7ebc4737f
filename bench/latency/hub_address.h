// SPDX-License-Identifier: Apache-2.0
// Address of a hub that the bench itself has started.
#pragma once

#include <string>
#include <vector>

#include "roomcast/core/assert.h"
#include "roomcast/net/hub_url.h"

namespace roomcast::bench {

[[nodiscard]] inline std::vector<net::HubUrl> hub_address(const std::string& url) {
  auto parsed = net::parse_hub_urls(url);
  ROOMCAST_ASSERT(parsed.ok());
  return *std::move(parsed);
}

}  // namespace roomcast::bench
