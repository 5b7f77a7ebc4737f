// SPDX-License-Identifier: Apache-2.0
// PeerCounts: counts the unsettled connections of each address, so that one address cannot use up
// all connections. Threading: enter() on one thread; a Place may be released on any thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <unordered_map>

namespace roomcast::net {

class PeerCounts {
 public:
  /// The reservation of one connection; its destructor frees it.
  class Place {
   public:
    explicit Place(std::shared_ptr<std::atomic<std::size_t>> count);
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

   private:
    std::shared_ptr<std::atomic<std::size_t>> count_;
  };

  /// Null: this address already has `limit` connections.
  [[nodiscard]] std::shared_ptr<Place> enter(const std::string& address, std::size_t limit);

 private:
  void remove_unused();

  std::unordered_map<std::string, std::shared_ptr<std::atomic<std::size_t>>> counts_;
  std::size_t forget_at_ = 1024;  // addresses
};

}  // namespace roomcast::net
