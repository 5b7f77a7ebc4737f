// SPDX-License-Identifier: Apache-2.0
// Calls that take long run on a thread of their own, without the interpreter's lock, while the
// calling thread looks for signals: Ctrl-C ends them. Threading: call with the lock.
#pragma once

#include <chrono>
#include <future>
#include <stop_token>
#include <thread>
#include <type_traits>
#include <utility>

#include <pybind11/pybind11.h>

#include "roomcast/python/without_gil.h"

namespace roomcast::python {

/// How long a signal may wait.
inline constexpr std::chrono::milliseconds kSignalPeriod{50};

/// Throws if a signal's handler raised an exception, such as KeyboardInterrupt.
inline void check_signals() {
  if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
}

/// Thrown by a step of a call that was stopped; it ends on the call's own thread.
struct Stopped {};

/// Returns what `call(stop_token)` returns. `call` must not use Python. After a signal it has to
/// end soon: by itself, or by throwing Stopped.
template <class Call>
auto interruptible(Call call) -> std::invoke_result_t<Call, std::stop_token> {
  using Value = std::invoke_result_t<Call, std::stop_token>;
  std::packaged_task<Value(std::stop_token)> task(std::move(call));
  std::future<Value> future = task.get_future();
  std::jthread thread(std::move(task));
  const auto is_ready = [&] {
    const WithoutGil without;
    return future.wait_for(kSignalPeriod) == std::future_status::ready;
  };
  while (!is_ready()) {
    if (PyErr_CheckSignals() == 0) continue;
    pybind11::error_already_set raised;
    thread.request_stop();
    {
      const WithoutGil without;
      thread.join();
    }
    throw raised;
  }
  return future.get();
}

}  // namespace roomcast::python
