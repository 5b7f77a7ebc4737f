// SPDX-License-Identifier: Apache-2.0
// Runs a function for every row of a picture on several threads. The rows must be independent of
// each other; then the result does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace roomcast {

inline constexpr int kMaxThreads = 64;

/// `threads`, or the number of cores for 0; at most kMaxThreads.
[[nodiscard]] inline int thread_count(int threads) {
  const auto cores = static_cast<int>(std::thread::hardware_concurrency());
  return std::clamp(threads > 0 ? threads : cores, 1, kMaxThreads);
}

template <class RowFunction>
void for_each_row(int rows, int threads, const RowFunction& row_function) {
  std::atomic<int> next_row = 0;
  const auto work = [&] {
    for (int row = next_row++; row < rows; row = next_row++) row_function(row);
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < thread_count(threads); ++i) helpers.emplace_back(work);
  work();
}

/// On all cores.
template <class RowFunction>
void for_each_row(int rows, const RowFunction& row_function) {
  for_each_row(rows, 0, row_function);
}

}  // namespace roomcast
