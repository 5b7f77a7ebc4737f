// SPDX-License-Identifier: Apache-2.0
// PeerOrigins: the web origins of the other hubs. When this hub is gone, its page may reconnect to
// one of them, and their pages to this hub, even long after a hub was last seen. Threading: the
// thread that accepts connections.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "roomcast/net/page_policy.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {

class PeerOrigins {
 public:
  static constexpr std::size_t kMax = wire::kMaxOtherHubs;

  /// Adds the URLs of hubs that are alive. Older entries stay while there are at most kMax.
  void add(const std::vector<std::string>& hub_urls) {
    for (const std::string& url : hub_urls) {
      const auto hub = net::parse_hub_url(url);
      if (!hub) continue;
      std::erase(hubs_, *hub);
      hubs_.push_back(*hub);
    }
    if (hubs_.size() > kMax) hubs_.erase(hubs_.begin(), hubs_.end() - kMax);
  }
  /// Whether this is the Origin of a page of one of these hubs.
  [[nodiscard]] bool has(std::string_view origin) const {
    return std::ranges::any_of(hubs_,
                               [origin](const auto& hub) { return net::site_of(hub) == origin; });
  }
  /// The content security policy for the page of this hub, which pages of `embedding_sites` may
  /// show.
  [[nodiscard]] std::string policy(const std::vector<std::string>& embedding_sites = {}) const {
    return net::page_policy(hubs_, embedding_sites);
  }

 private:
  std::vector<net::HubUrl> hubs_;  // newest last
};

}  // namespace roomcast::hub
