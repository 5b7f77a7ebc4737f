// SPDX-License-Identifier: Apache-2.0
// Runs a function for every row of a picture on the machine's cores. The rows must not depend on
// each other; then the result does not depend on the number of threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace roomcast::sim {

template <class RowFunction>
void for_each_row(int rows, const RowFunction& row_function) {
  constexpr unsigned kMostThreads = 8;
  const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1U, kMostThreads);
  std::atomic<int> next_row = 0;
  const auto work = [&] {
    for (int row = next_row++; row < rows; row = next_row++) row_function(row);
  };
  std::vector<std::jthread> helpers;
  for (unsigned i = 1; i < threads; ++i) helpers.emplace_back(work);
  work();
}

}  // namespace roomcast::sim
