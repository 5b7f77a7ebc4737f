// SPDX-License-Identifier: Apache-2.0
// Runs numbered tasks on several threads and reports their completion on the calling thread in the
// order of their numbers. Tasks run at most a few per thread ahead of the oldest unfinished one, so
// memory is bounded. The first failure stops the remaining tasks.
#pragma once

#include <functional>

#include "roomcast/core/result.h"

namespace roomcast {

/// Calls `work(thread, task)` on one of `threads` threads (numbered from 0), then `done(task)` on
/// the calling thread; either may fail. Returns the first failure.
[[nodiscard]] Status run_in_order(int tasks, int threads,
                                  const std::function<Status(int thread, int task)>& work,
                                  const std::function<Status(int task)>& done);

}  // namespace roomcast
