// SPDX-License-Identifier: Apache-2.0
#include "roomcast/cli/stop_on_signal.h"

#include <csignal>
#include <future>

#include <gtest/gtest.h>
#include <pthread.h>
#include <unistd.h>

namespace roomcast::cli {
namespace {

/// Restores the signal mask of the test's thread afterwards, because other tests rely on it.
class StopOnSignalTest : public testing::Test {
 protected:
  StopOnSignalTest() { pthread_sigmask(SIG_SETMASK, nullptr, &before_); }
  ~StopOnSignalTest() override { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  sigset_t before_{};
};

TEST_F(StopOnSignalTest, sigterm_and_ctrl_c_are_a_stop) {
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
    const StopOnSignal stop;
    std::promise<void> stopped;
    const std::stop_callback tell(stop.token(), [&] { stopped.set_value(); });
    ::kill(::getpid(), signal);
    stopped.get_future().wait();
  }
}

TEST_F(StopOnSignalTest, a_hangup_can_mean_something_else) {
  std::promise<void> hung_up;
  const StopOnSignal stop([&] { hung_up.set_value(); });
  ::kill(::getpid(), SIGHUP);
  hung_up.get_future().wait();
  EXPECT_FALSE(stop.token().stop_requested());
}

TEST_F(StopOnSignalTest, without_a_signal_it_ends_and_requests_no_stop) {
  std::stop_token token;
  {
    const StopOnSignal stop;
    token = stop.token();
  }
  EXPECT_FALSE(token.stop_requested());
}

}  // namespace
}  // namespace roomcast::cli
