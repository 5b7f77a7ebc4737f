// SPDX-License-Identifier: Apache-2.0
// Tests that need no hub. tests/cli runs the examples against a hub.
#include "roomcast/capi/roomcast.h"

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

namespace {

roomcast_options options_for(const char* hub) {
  roomcast_options options{};
  options.size = sizeof(options);
  options.hub = hub;
  return options;
}

TEST(CApi, a_hub_that_is_not_there_is_named) {
  char error[200] = "";
  const roomcast_options options = options_for("ws://127.0.0.1:1");
  EXPECT_EQ(roomcast_connect(&options, error, sizeof(error)), nullptr);
  EXPECT_NE(std::string(error).find("127.0.0.1"), std::string::npos) << error;
}

TEST(CApi, a_sentence_is_cut_to_the_room_there_is) {
  char error[8] = "";
  const roomcast_options options = options_for("ftp://x");
  EXPECT_EQ(roomcast_connect(&options, error, sizeof(error)), nullptr);
  EXPECT_EQ(std::string(error).size(), 7u);
  EXPECT_EQ(roomcast_connect(&options, nullptr, 0), nullptr);
}

TEST(CApi, options_of_an_earlier_header_are_understood) {
  char error[200] = "";
  roomcast_options options = options_for("ftp://x");
  options.size = offsetof(roomcast_options, room);
  options.room = reinterpret_cast<const char*>(1);  // beyond options.size: must not be read
  EXPECT_EQ(roomcast_connect(&options, error, sizeof(error)), nullptr);
  EXPECT_NE(std::string(error), "");
}

TEST(CApi, a_pose_that_is_no_rigid_motion_is_refused_before_anything_is_sent) {
  const double mirrored[16] = {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const double still[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  char error[200] = "";
  roomcast_viewer* const nobody = nullptr;
  roomcast_pose pose{sizeof(pose), still, mirrored, nullptr};
  EXPECT_EQ(roomcast_send_pose(nobody, &pose, error, sizeof(error)), 0);
  EXPECT_EQ(std::string(error).find("world_from_left_hand"), 0u) << error;
  pose = {sizeof(pose), nullptr, nullptr, nullptr};
  EXPECT_EQ(roomcast_send_pose(nobody, &pose, error, sizeof(error)), 0);
  EXPECT_EQ(std::string(error).find("world_from_head"), 0u) << error;
}

TEST(CApi, closing_null_does_nothing) {
  roomcast_disconnect(nullptr);
  roomcast_free_frames(nullptr);
  roomcast_free_people(nullptr);
  roomcast_stop_publishing(nullptr);
  roomcast_close(nullptr);
}

TEST(CApi, reports_its_version) {
  EXPECT_EQ(std::string(roomcast_version()).substr(0, 2), "1.");
}

}  // namespace
