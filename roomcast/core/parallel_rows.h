// SPDX-License-Identifier: Apache-2.0
// Runs a function for every row of a picture on several threads. The rows must be independent of
// each other; then the result does not depend on the number of threads. Whoever requests a stop
// gets a picture that lacks rows.
#pragma once

#include <algorithm>
#include <atomic>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

namespace roomcast {

inline constexpr int kMaxThreads = 64;

/// `threads`, or the number of cores for 0; at most kMaxThreads.
[[nodiscard]] inline int thread_count(int threads) {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(threads > 0 ? threads : cores, 1, kMaxThreads);
}

/// How many threads work on a picture (0: one per core), and until when.
struct Workers {
  Workers(int count = 0, std::stop_token until = {}) : threads(count), stop(std::move(until)) {}
  int threads;
  std::stop_token stop;
};

/// After a stop request the remaining rows are left out.
template <class RowFunction>
void for_each_row(int rows, const Workers& workers, const RowFunction& row_function) {
  std::atomic<int> next_row = 0;
  const auto work = [&] {
    for (int row = next_row++; row < rows && !workers.stop.stop_requested(); row = next_row++)
      row_function(row);
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < thread_count(workers.threads); ++i) helpers.emplace_back(work);
  work();
}

/// On all cores.
template <class RowFunction>
void for_each_row(int rows, const RowFunction& row_function) {
  for_each_row(rows, 0, row_function);
}

}  // namespace roomcast
