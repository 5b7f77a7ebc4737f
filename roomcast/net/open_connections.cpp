// SPDX-License-Identifier: Apache-2.0
#include "roomcast/net/open_connections.h"

#include <utility>
#include <vector>

namespace roomcast::net {

OpenConnections::Lease::Lease(std::shared_ptr<OpenConnections> owner) : owner_(std::move(owner)) {
  ++owner_->count_;
}

OpenConnections::Lease::~Lease() {
  if (end_) owner_->endable_.erase(this);
  --owner_->count_;
}

void OpenConnections::Lease::end_with(std::function<void()> end) {
  if (!end_ && end) owner_->endable_.insert(this);
  if (end_ && !end) owner_->endable_.erase(this);
  end_ = std::move(end);
  if (!end_ || !owner_->over_) return;
  const auto end_now = end_;  // a copy: the call may release this lease
  end_now();
}

std::shared_ptr<OpenConnections::Lease> OpenConnections::open() {
  return std::make_shared<Lease>(shared_from_this());
}

void OpenConnections::end_all() {
  over_ = true;
  std::vector<std::function<void()>> ends;  // a copy: ending one may release its lease
  for (const Lease* lease : endable_) ends.push_back(lease->end_);
  for (const auto& end : ends) end();
}

}  // namespace roomcast::net
