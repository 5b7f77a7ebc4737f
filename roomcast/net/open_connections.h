// SPDX-License-Identifier: Apache-2.0
// OpenConnections: counts the open sockets of one thread and can close each of them. Threading:
// count() and open() from any thread; the rest on the thread that serves the sockets. A lease
// without an `end` function may be released on any thread.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <unordered_set>

namespace roomcast::net {

class OpenConnections : public std::enable_shared_from_this<OpenConnections> {
 public:
  /// One open socket: kept as long as the socket is open; its destructor decrements the count.
  class Lease {
   public:
    explicit Lease(std::shared_ptr<OpenConnections> owner);
    ~Lease();
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;

    /// Sets the function by which end_all() closes this socket; empty: none.
    void end_with(std::function<void()> end);

   private:
    friend class OpenConnections;
    std::shared_ptr<OpenConnections> owner_;
    std::function<void()> end_;
  };

  [[nodiscard]] std::shared_ptr<Lease> open();
  [[nodiscard]] std::size_t count() const { return count_; }
  /// Leases that come later are closed when they set their `end` function.
  void end_all();

 private:
  std::atomic<std::size_t> count_ = 0;
  std::unordered_set<Lease*> endable_;
  bool over_ = false;
};

}  // namespace roomcast::net
