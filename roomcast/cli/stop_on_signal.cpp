// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/stop_on_signal.h"

#include <csignal>

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

StopOnSignal::StopOnSignal() {
  const sigset_t signals = end_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  waiter_ = std::jthread([this, signals](const std::stop_token& done) {
    const timespec look_up{.tv_sec = 0, .tv_nsec = 100'000'000};
    while (!done.stop_requested()) {
      if (sigtimedwait(&signals, nullptr, &look_up) > 0) stop_.request_stop();
    }
  });
}

StopOnSignal::~StopOnSignal() = default;

}  // namespace roomcast::cli
