// SPDX-License-Identifier: Apache-2.0
// For tests: a participant of a domain that ROS 2 systems do not use by chance, on this computer
// only, and waiting with an end.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "roomcast/core/clock.h"
#include "roomcast/ros2/dds/participant.h"

namespace roomcast::ros2 {

/// Differs between test programs that run at the same time, mostly; topics of all are in a test's
/// own process, so that a shared one does no harm.
inline int test_domain() {
  return 20 + getpid() % 80;  // ports below those that systems give out
}

inline std::unique_ptr<Participant> join_test_domain() {
  auto participant = Participant::open({.domain = test_domain(), .only_localhost = true});
  EXPECT_TRUE(participant.ok()) << participant.error().message;
  return *std::move(participant);
}

/// Whether `condition` holds within 10 s.
template <class Condition>
bool soon(Participant& participant, Condition condition) {
  const HostTime end = SteadyClock().now() + std::chrono::seconds(10);
  while (!condition()) {
    if (SteadyClock().now() > end) return false;
    participant.wait(std::chrono::milliseconds(10));
  }
  return true;
}

}  // namespace roomcast::ros2
