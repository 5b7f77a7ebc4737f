// SPDX-License-Identifier: Apache-2.0
#include "roomcast/core/ordered_parallel.h"

#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace roomcast {
namespace {

/// State shared by the threads: the next task, the finished tasks, and whether to continue.
class TaskState {
 public:
  TaskState(int tasks, int most_ahead) : tasks_(tasks), max_ahead_(most_ahead) {}

  /// The next task, or -1 when there is none left.
  int take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopped_ || next_ < handed_on_ + max_ahead_; });
    return stopped_ || next_ >= tasks_ ? -1 : next_++;
  }

  void end(int task, Status status) {
    const std::scoped_lock lock(mutex_);
    if (!status && failure_.ok()) failure_ = std::move(status);
    ended_.insert(task);
    changed_.notify_all();
  }

  /// Waits until this task has finished or any has failed; returns the first failure.
  Status wait_for(int task) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !failure_.ok() || ended_.count(task) > 0; });
    return failure_;
  }

  void mark_done(int task) {
    const std::scoped_lock lock(mutex_);
    ended_.erase(task);
    handed_on_ = task + 1;
    changed_.notify_all();
  }

  void stop() {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
    changed_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  const int tasks_, max_ahead_;
  int next_ = 0, handed_on_ = 0;
  bool stopped_ = false;
  Status failure_;
  std::set<int> ended_;
};

}  // namespace

Status run_in_order(int tasks, int threads, const std::function<Status(int, int)>& work,
                    const std::function<Status(int)>& done) {
  constexpr int kAheadPerThread = 3;
  TaskState ledger(tasks, kAheadPerThread * threads);
  std::vector<std::jthread> workers;
  for (int thread = 0; thread < threads; ++thread) {
    workers.emplace_back([&ledger, &work, thread] {
      for (int task = ledger.take(); task >= 0; task = ledger.take())
        ledger.end(task, work(thread, task));
    });
  }
  Status status;
  for (int task = 0; task < tasks && status.ok(); ++task) {
    status = ledger.wait_for(task);
    if (status.ok()) status = done(task);
    if (status.ok()) ledger.mark_done(task);
  }
  ledger.stop();
  return status;
}

}  // namespace roomcast
