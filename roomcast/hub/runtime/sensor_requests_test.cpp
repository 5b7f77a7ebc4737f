// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/sensor_requests.h"

#include <optional>

#include <gtest/gtest.h>

namespace roomcast::hub {
namespace {

constexpr ConnectionId kOne{1}, kOther{2};
constexpr HostTime kNow{std::chrono::seconds(100)};

struct Asked {
  std::optional<Status> outcome;
  SensorRequests::Answered answered() {
    return [this](const Status& status) { outcome = status; };
  }
};

wire::pb::SettingsAnswer answer_to(std::uint32_t number, const std::string& refusal = "") {
  wire::pb::SettingsAnswer answer;
  answer.set_number(number);
  answer.set_refusal(refusal);
  return answer;
}

TEST(SensorRequests, are_answered_once_by_the_sensor_that_was_asked) {
  SensorRequests requests;
  Asked asked;
  const auto number = requests.open(kOne, kNow, asked.answered());
  requests.answer(kOther, answer_to(number));
  requests.answer(kOne, answer_to(number + 1));
  EXPECT_FALSE(asked.outcome);
  requests.answer(kOne, answer_to(number));
  ASSERT_TRUE(asked.outcome);
  EXPECT_TRUE(asked.outcome->ok());
  asked.outcome.reset();
  requests.answer(kOne, answer_to(number));
  EXPECT_FALSE(asked.outcome);
}

TEST(SensorRequests, a_refusal_is_told_in_the_sensors_words) {
  SensorRequests requests;
  Asked asked;
  requests.answer(kOne, answer_to(requests.open(kOne, kNow, asked.answered()), "I cannot"));
  EXPECT_EQ(asked.outcome->error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(asked.outcome->error().message, "I cannot");
}

TEST(SensorRequests, end_when_the_sensor_leaves_or_says_nothing) {
  SensorRequests requests;
  Asked gone, silent;
  requests.open(kOne, kNow, gone.answered());
  requests.open(kOther, kNow, silent.answered());
  requests.sensor_left(kOne);
  EXPECT_EQ(gone.outcome->error().code, ErrorCode::kUnavailable);
  requests.give_up_before(kNow + SensorRequests::kPatience);
  EXPECT_FALSE(silent.outcome);
  requests.give_up_before(kNow + SensorRequests::kPatience + std::chrono::seconds(1));
  EXPECT_EQ(silent.outcome->error().code, ErrorCode::kUnavailable);
}

TEST(SensorRequests, are_so_many_and_no_more) {
  SensorRequests requests;
  Asked asked;
  for (std::size_t i = 0; i < SensorRequests::kMaxOpen; ++i)
    EXPECT_NE(requests.open(kOne, kNow, [](const Status&) {}), 0U);
  EXPECT_EQ(requests.open(kOne, kNow, asked.answered()), 0U);
  EXPECT_EQ(asked.outcome->error().code, ErrorCode::kUnavailable);
}

}  // namespace
}  // namespace roomcast::hub
