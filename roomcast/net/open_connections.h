// SPDX-License-Identifier: Apache-2.0
// OpenConnections: counts a server's open sockets and knows how to end each of them.
// Threading: one thread, with everyone that holds a lease.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <unordered_set>

namespace roomcast::net {

class OpenConnections : public std::enable_shared_from_this<OpenConnections> {
 public:
  /// Held as long as a socket is open; given back by letting go.
  class Lease {
   public:
    explicit Lease(std::shared_ptr<OpenConnections> owner);
    ~Lease();
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;

    /// How this socket is ended when all are.
    void end_with(std::function<void()> end) { end_ = std::move(end); }

   private:
    friend class OpenConnections;
    std::shared_ptr<OpenConnections> owner_;
    std::function<void()> end_;
  };

  [[nodiscard]] std::shared_ptr<Lease> open();
  [[nodiscard]] std::size_t count() const { return leases_.size(); }
  void end_all();

 private:
  std::unordered_set<Lease*> leases_;
};

}  // namespace roomcast::net
