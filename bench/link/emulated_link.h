// SPDX-License-Identifier: Apache-2.0
// EmulatedLink: two network namespaces, joined by a link as slow, long and lossy as one likes. Real
// TCP of this kernel runs over it. For kernels without netem; needs root (CAP_SYS_ADMIN and
// CAP_NET_ADMIN) and /dev/net/tun.
//
// Threading: open() and the destructor on one thread; run() from any. A thread's sockets belong to
// the end at which they were made.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include "bench/link/link_queue.h"
#include "roomcast/core/result.h"

namespace roomcast::bench {

class EmulatedLink {
 public:
  enum class End { kNear, kFar };

  /// kUnsupported: not root, or no TUN devices here.
  static Result<std::unique_ptr<EmulatedLink>> open(const LinkSpec& spec);
  ~EmulatedLink();

  /// Calls `work` on a thread of its own at this end, and waits. Threads that it starts are there
  /// too.
  void run(End end, const std::function<void()>& work) const;

  /// Under which the end is known at both ends.
  [[nodiscard]] static const char* address(End end);

  /// Of IP packets that went from the near to the far end, lost ones left out.
  [[nodiscard]] std::uint64_t carried_bytes() const;

 private:
  class Pump;
  explicit EmulatedLink(std::unique_ptr<Pump> pump);
  std::unique_ptr<Pump> pump_;
};

}  // namespace roomcast::bench
