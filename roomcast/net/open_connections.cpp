// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/open_connections.h"

#include <utility>
#include <vector>

namespace roomcast::net {

OpenConnections::Lease::Lease(std::shared_ptr<OpenConnections> owner) : owner_(std::move(owner)) {
  owner_->leases_.insert(this);
}

OpenConnections::Lease::~Lease() {
  owner_->leases_.erase(this);
}

std::shared_ptr<OpenConnections::Lease> OpenConnections::open() {
  return std::make_shared<Lease>(shared_from_this());
}

void OpenConnections::end_all() {
  std::vector<std::function<void()>> ends;  // a copy: ending one may give back its lease
  for (const Lease* lease : leases_) {
    if (lease->end_) ends.push_back(lease->end_);
  }
  for (const auto& end : ends) end();
}

}  // namespace roomcast::net
