// SPDX-License-Identifier: Apache-2.0
#include "roomcast/python/without_gil.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace roomcast::python {
namespace {

/// How long the interpreter's end waits for threads that still work without its lock.
constexpr std::chrono::seconds kLongestWait{2};

/// The threads without the lock. One for the process, as the interpreter is.
struct Threads {
  std::mutex mutex;
  std::condition_variable changed;
  int working = 0;          // without the lock
  int asking = 0;           // for the lock
  bool is_exiting = false;  // from now on no thread but `last` may ask for the lock
  std::thread::id last;
};

Threads& threads() {
  static Threads& all = *new Threads;  // never destroyed: threads may come back at any time
  return all;
}

[[noreturn]] void wait_for_the_end_of_the_process() {
  for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

/// Afterwards no thread but this one asks for the lock again.
void prepare_for_exit() {
  Threads& all = threads();
  PyThreadState* const state = PyEval_SaveThread();
  {
    std::unique_lock lock(all.mutex);
    all.is_exiting = true;
    all.last = std::this_thread::get_id();
    all.changed.wait(lock, [&] { return all.asking == 0; });
    all.changed.wait_for(lock, kLongestWait, [&] { return all.working == 0; });
  }
  PyEval_RestoreThread(state);
}

}  // namespace

WithoutGil::WithoutGil()
    : state_([] {
        {
          const std::lock_guard lock(threads().mutex);
          ++threads().working;
        }
        return PyEval_SaveThread();
      }()) {}

WithoutGil::~WithoutGil() {
  Threads& all = threads();
  bool may_ask = false;
  {
    const std::lock_guard lock(all.mutex);
    --all.working;
    may_ask = !all.is_exiting || all.last == std::this_thread::get_id();
    if (may_ask) ++all.asking;
    all.changed.notify_all();
  }
  if (!may_ask) wait_for_the_end_of_the_process();
  PyEval_RestoreThread(state_);
  const std::lock_guard lock(all.mutex);
  --all.asking;
  all.changed.notify_all();
}

void register_exit(pybind11::module_& module) {
  module.def("_prepare_for_exit", &prepare_for_exit);
  pybind11::module_::import("atexit").attr("register")(module.attr("_prepare_for_exit"));
}

}  // namespace roomcast::python
