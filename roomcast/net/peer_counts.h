// SPDX-License-Identifier: Apache-2.0
// PeerCounts: how many connections of each address have not yet shown what they are for, so that
// one address cannot take all the places. Threading: enter() on one thread; a place may be left on
// any.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <unordered_map>

namespace roomcast::net {

class PeerCounts {
 public:
  /// One connection's place; left when it is let go.
  class Place {
   public:
    explicit Place(std::shared_ptr<std::atomic<std::size_t>> count);
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

   private:
    std::shared_ptr<std::atomic<std::size_t>> count_;
  };

  /// Null: this address has `limit` already.
  [[nodiscard]] std::shared_ptr<Place> enter(const std::string& address, std::size_t limit);

 private:
  void forget_the_gone();

  std::unordered_map<std::string, std::shared_ptr<std::atomic<std::size_t>>> counts_;
  std::size_t forget_at_ = 1024;  // addresses
};

}  // namespace roomcast::net
