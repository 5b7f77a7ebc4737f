// SPDX-License-Identifier: Apache-2.0
// PeerOrigins: hubs beside this one, as browsers see them. The page of this hub may go on at one of
// them when this one is gone, and theirs here: also long after we have seen the last of them.
// Threading: the door's.
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

  /// Addresses of hubs that are there now; those that were stay, as long as there is room.
  void are(const std::vector<std::string>& hub_urls) {
    for (const std::string& url : hub_urls) {
      const auto hub = net::parse_hub_url(url);
      if (!hub) continue;
      std::erase(hubs_, *hub);
      hubs_.push_back(*hub);
    }
    if (hubs_.size() > kMax) hubs_.erase(hubs_.begin(), hubs_.end() - kMax);
  }
  /// Is this the Origin of a page of theirs?
  [[nodiscard]] bool has(std::string_view origin) const {
    return std::ranges::any_of(hubs_,
                               [origin](const auto& hub) { return net::site_of(hub) == origin; });
  }
  /// What the page of this hub may do.
  [[nodiscard]] std::string policy() const { return net::page_policy(hubs_); }

 private:
  std::vector<net::HubUrl> hubs_;  // newest last
};

}  // namespace roomcast::hub
