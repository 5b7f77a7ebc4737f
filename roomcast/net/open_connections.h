// SPDX-License-Identifier: Apache-2.0
// OpenConnections: counts the open sockets of one thread and knows how to end each of them.
// Threading: count() and open() from any thread; the rest on the one that serves the sockets. A
// lease that was never told how to end may be let go anywhere.
#pragma once

#include <atomic>
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
    void end_with(std::function<void()> end);

   private:
    friend class OpenConnections;
    std::shared_ptr<OpenConnections> owner_;
    std::function<void()> end_;
  };

  [[nodiscard]] std::shared_ptr<Lease> open();
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Those that come later end as soon as they say how.
  void end_all();

 private:
  std::atomic<std::size_t> count_ = 0;
  std::unordered_set<Lease*> endable_;
  bool over_ = false;
};

}  // namespace roomcast::net
