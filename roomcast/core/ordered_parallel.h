// SPDX-License-Identifier: Apache-2.0
// Runs numbered tasks on several threads and hands their ends to the calling thread in the order of
// their numbers. At most a few tasks per thread are ahead of the slowest one, so memory is bounded.
// The first task that fails stops the rest.
#pragma once

#include <functional>

#include "roomcast/core/result.h"

namespace roomcast {

/// `work(thread, task)` on one of `threads` threads (numbered from 0), then `done(task)` on the
/// calling thread; either may fail. Returns the first failure.
[[nodiscard]] Status run_in_order(int tasks, int threads,
                                  const std::function<Status(int thread, int task)>& work,
                                  const std::function<Status(int task)>& done);

}  // namespace roomcast
