// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>

#include <gtest/gtest.h>

#include "roomcast/ros2/dds/participant.h"

namespace roomcast::ros2 {
namespace {

class Ros2Options : public testing::Test {
 protected:
  Ros2Options() { forget(); }
  ~Ros2Options() override { forget(); }
  static void forget() {
    unsetenv("ROS_DOMAIN_ID");
    unsetenv("ROS_LOCALHOST_ONLY");
  }
};

TEST_F(Ros2Options, are_those_of_ros_variables) {
  EXPECT_EQ(options_of_environment()->domain, 0);
  EXPECT_FALSE(options_of_environment()->only_localhost);
  setenv("ROS_DOMAIN_ID", "42", 1);
  setenv("ROS_LOCALHOST_ONLY", "1", 1);
  EXPECT_EQ(options_of_environment()->domain, 42);
  EXPECT_TRUE(options_of_environment()->only_localhost);
}

TEST_F(Ros2Options, domains_that_dds_has_no_ports_for_are_refused) {
  for (const char* domain : {"233", "-1", "x", "4 ", "99999999999"}) {
    setenv("ROS_DOMAIN_ID", domain, 1);
    EXPECT_FALSE(options_of_environment().ok()) << domain;
  }
  EXPECT_FALSE(ParticipantOptions{.domain = 233}.check().ok());
  EXPECT_FALSE(ParticipantOptions{.domain = -1}.check().ok());
}

}  // namespace
}  // namespace roomcast::ros2
