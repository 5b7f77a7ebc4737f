// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/hub_choice.h"

#include <algorithm>
#include <utility>

#include "roomcast/core/assert.h"

namespace roomcast::client {

HubChoice::HubChoice(std::vector<net::HubUrl> named, std::uint32_t seed)
    : named_(std::move(named)), hubs_(named_), pace_(seed) {
  ROOMCAST_ASSERT(!named_.empty());
}

std::vector<net::HubUrl> HubChoice::to_try() const {
  std::vector<net::HubUrl> hubs = hubs_;
  if (avoids_current_) std::erase(hubs, current());
  return hubs.empty() ? hubs_ : hubs;
}

void HubChoice::learn(const std::vector<std::string>& urls) {
  const net::HubUrl stays = current();
  hubs_ = named_;
  const auto add = [this](const net::HubUrl& hub) {
    if (std::ranges::find(hubs_, hub) == hubs_.end()) hubs_.push_back(hub);
  };
  add(stays);
  for (const std::string& url : urls) {
    if (const auto hub = net::parse_hub_url(url)) add(*hub);
  }
  answered(stays);
}

void HubChoice::answered(const net::HubUrl& hub) {
  current_ = static_cast<std::size_t>(std::ranges::find(hubs_, hub) - hubs_.begin());
  ROOMCAST_ASSERT(current_ < hubs_.size());
  avoids_current_ = false;
}

std::chrono::nanoseconds HubChoice::failed() {
  avoids_current_ = true;
  return ++failures_ % hubs_.size() == 0 ? pace_.next() : std::chrono::nanoseconds(0);
}

std::chrono::nanoseconds HubChoice::nobody_answered() {
  avoids_current_ = false;
  return pace_.next();
}

}  // namespace roomcast::client
