// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/key_request_pace.h"

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;

RoomTime requested_at(nanoseconds since_start) {
  return RoomTime(1h + since_start);
}

TEST(KeyRequestPace, the_first_request_goes_out_at_once) {
  KeyRequestPace pace;
  EXPECT_EQ(pace.next(), std::nullopt);
  EXPECT_TRUE(pace.request(requested_at(0s)));
  EXPECT_EQ(pace.next(), std::nullopt);
}

TEST(KeyRequestPace, requests_in_between_become_one) {
  KeyRequestPace pace;
  EXPECT_TRUE(pace.request(requested_at(0ms)));
  EXPECT_FALSE(pace.request(requested_at(100ms)));
  EXPECT_FALSE(pace.request(requested_at(200ms)));
  EXPECT_EQ(pace.next(), requested_at(500ms));
  EXPECT_FALSE(pace.due(requested_at(499ms)));
  EXPECT_TRUE(pace.due(requested_at(500ms)));
  EXPECT_FALSE(pace.due(requested_at(2s)));
}

TEST(KeyRequestPace, a_key_frame_answers_what_was_remembered) {
  KeyRequestPace pace;
  EXPECT_TRUE(pace.request(requested_at(0ms)));
  EXPECT_FALSE(pace.request(requested_at(100ms)));
  pace.key_frame_came();
  EXPECT_FALSE(pace.due(requested_at(600ms)));
}

}  // namespace
}  // namespace roomcast::hub
