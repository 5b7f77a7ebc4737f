// SPDX-License-Identifier: Apache-2.0
// EmulatedLink: two network namespaces, joined by a link of configurable rate, delay and loss. Real
// TCP of this kernel runs over it. For kernels without netem; needs root (CAP_SYS_ADMIN and
// CAP_NET_ADMIN) and /dev/net/tun.
//
// Threading: open() and the destructor on one thread; run() from any. A socket belongs to the end
// at which it was made.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>

#include "bench/link/link_queue.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

class EmulatedLink {
 public:
  enum class End { kNear, kFar };

  /// kUnsupported: not root, or no TUN devices.
  static Result<std::unique_ptr<EmulatedLink>> open(const LinkSpec& spec);
  ~EmulatedLink();

  /// Calls `work` on a new thread at this end, and waits. Threads started by `work` are at this end
  /// too.
  void run(End end, const std::function<void()>& work) const;

  /// The link carries so much from now on, each way. Thread-safe.
  void set_rate(double mbit_per_s);

  /// Nothing passes for so long, either way; packets wait. Thread-safe.
  void stop_for(std::chrono::milliseconds duration);

  /// The address of this end, valid at both ends.
  [[nodiscard]] static const char* address(End end);

  /// Total IP packets from the near to the far end, without lost ones.
  [[nodiscard]] std::uint64_t carried_bytes() const;

 private:
  class Pump;
  explicit EmulatedLink(std::unique_ptr<Pump> pump);
  std::unique_ptr<Pump> pump_;
};

}  // namespace roomcast::bench
