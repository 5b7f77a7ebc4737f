// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/report/toasts.h"

#include <gtest/gtest.h>

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

HostTime at(nanoseconds since_start) {
  return HostTime(1h + since_start);
}

RoomProblem lost_hub() {
  return {RoomProblem::Severity::kError, "hub", "The hub is lost."};
}

TEST(Toasts, a_sentence_about_an_event_is_shown_for_a_while) {
  Toasts toasts;
  toasts.add(Toast::Kind::kGood, "Saved.", at(0s));
  ASSERT_EQ(toasts.current(at(4s)).size(), 1U);
  EXPECT_EQ(toasts.current(at(4s))[0].sentence, "Saved.");
  EXPECT_TRUE(toasts.current(at(6s)).empty());
}

TEST(Toasts, a_problem_stays_until_it_is_solved_and_then_good_news_is_shown) {
  Toasts toasts;
  toasts.set_problems({lost_hub()}, at(0s));
  EXPECT_EQ(toasts.current(at(1h)).at(0).kind, Toast::Kind::kError);
  toasts.set_problems({}, at(1h));
  ASSERT_EQ(toasts.current(at(1h)).size(), 1U);
  EXPECT_EQ(toasts.current(at(1h))[0].kind, Toast::Kind::kGood);
  EXPECT_EQ(toasts.current(at(1h))[0].sentence, "The hub is back.");
}

TEST(Toasts, a_lost_hub_does_not_count_as_a_solved_sensor_problem) {
  Toasts toasts;
  toasts.set_problems({{RoomProblem::Severity::kNotice, "left", "Sensor left is gone."}}, at(0s));
  toasts.set_problems({lost_hub()}, at(1s));
  ASSERT_EQ(toasts.current(at(1s)).size(), 1U);
}

TEST(Toasts, a_sentence_that_counts_seconds_is_no_new_problem) {
  Toasts toasts;
  toasts.set_problems({{RoomProblem::Severity::kError, "left", "silent for 3 s."}}, at(0s));
  toasts.set_problems({{RoomProblem::Severity::kError, "left", "silent for 4 s."}}, at(1s));
  ASSERT_EQ(toasts.current(at(1s)).size(), 1U);
  EXPECT_EQ(toasts.current(at(1s))[0].sentence, "silent for 4 s.");
}

TEST(Toasts, notices_that_last_are_before_the_eyes_only_at_first) {
  Toasts toasts;
  const RoomProblem notice = {RoomProblem::Severity::kNotice, "left", "Sensor left is gone."};
  toasts.set_problems({lost_hub(), notice}, at(0s));
  EXPECT_EQ(toasts.before_eyes(at(1s)).size(), 2U);
  toasts.set_problems({lost_hub(), notice}, at(6s));
  EXPECT_EQ(toasts.before_eyes(at(6s)),
            std::vector<Toast>({{Toast::Kind::kError, "The hub is lost."}}));
  EXPECT_EQ(toasts.current(at(6s)).size(), 2U);
  toasts.add(Toast::Kind::kGood, "Saved.", at(7s));
  EXPECT_EQ(toasts.before_eyes(at(8s)).size(), 2U);
  toasts.set_problems({{RoomProblem::Severity::kError, "left", "Sensor left is silent."}}, at(9s));
  EXPECT_EQ(toasts.before_eyes(at(9s)).front().sentence, "Sensor left is silent.");
}

TEST(Toasts, never_fill_the_screen) {
  Toasts toasts;
  for (int i = 0; i < 100; ++i) toasts.add(Toast::Kind::kNotice, std::to_string(i), at(0s));
  EXPECT_EQ(toasts.current(at(1s)).size(), Toasts::kMax);
  EXPECT_EQ(toasts.current(at(1s)).back().sentence, "99");
}

}  // namespace
}  // namespace roomcast::viewer
