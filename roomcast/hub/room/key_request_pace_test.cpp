// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/key_request_pace.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

RoomTime at(nanoseconds since_start) {
  return RoomTime(1h + since_start);
}

TEST(KeyRequestPace, the_first_request_goes_out_at_once) {
  KeyRequestPace pace;
  EXPECT_EQ(pace.next(), std::nullopt);
  EXPECT_TRUE(pace.request(at(0s)));
  EXPECT_EQ(pace.next(), std::nullopt);
}

TEST(KeyRequestPace, requests_in_between_become_one) {
  KeyRequestPace pace;
  EXPECT_TRUE(pace.request(at(0ms)));
  EXPECT_FALSE(pace.request(at(100ms)));
  EXPECT_FALSE(pace.request(at(200ms)));
  EXPECT_EQ(pace.next(), at(500ms));
  EXPECT_FALSE(pace.due(at(499ms)));
  EXPECT_TRUE(pace.due(at(500ms)));
  EXPECT_FALSE(pace.due(at(2s)));
}

TEST(KeyRequestPace, a_key_frame_answers_what_was_remembered) {
  KeyRequestPace pace;
  EXPECT_TRUE(pace.request(at(0ms)));
  EXPECT_FALSE(pace.request(at(100ms)));
  pace.key_frame_came();
  EXPECT_FALSE(pace.due(at(600ms)));
}

}  // namespace
}  // namespace roomcast::hub
