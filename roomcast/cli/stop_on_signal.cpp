// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/stop_on_signal.h"

#include <csignal>
#include <utility>

#include <pthread.h>

namespace roomcast::cli {
namespace {

sigset_t end_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGHUP);
  return signals;
}

}  // namespace

StopOnSignal::StopOnSignal(std::function<void()> on_hangup) {
  const sigset_t signals = end_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  waiter_ =
      std::jthread([this, signals, on_hangup = std::move(on_hangup)](const std::stop_token& done) {
        const std::stop_callback wake_up(done, [thread = pthread_self()] {
          pthread_kill(thread, SIGTERM);  // to this thread only
        });
        for (int signal = 0; sigwait(&signals, &signal) == 0 && !done.stop_requested();) {
          if (signal == SIGHUP && on_hangup) {
            on_hangup();
          } else {
            stop_.request_stop();
          }
        }
      });
}

StopOnSignal::~StopOnSignal() = default;

}  // namespace roomcast::cli
