// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/daemon/retention.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace roomcast::hub::daemon {
namespace {

using std::chrono::days;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr nanoseconds kToday = days(20'000);

AgingRecording recorded(const std::string& name, int days_ago, std::uint64_t bytes,
                        const std::string& room = "lab") {
  return {.name = name, .room = room, .bytes = bytes, .ended_at = kToday - days(days_ago)};
}

std::vector<std::string> names_of(const std::vector<AgingRecording>& recordings) {
  std::vector<std::string> names;
  for (const auto& recording : recordings) names.push_back(recording.name);
  return names;
}

TEST(Retention, without_limits_all_are_kept) {
  EXPECT_FALSE(Retention{}.any());
  EXPECT_THAT(outdated({recorded("a", 9'000, 1ULL << 60)}, {}, kToday), IsEmpty());
}

TEST(Retention, those_that_are_too_old_are_deleted) {
  const auto deleted =
      outdated({recorded("new", 29, 1), recorded("on the day", 30, 1), recorded("old", 31, 1)},
               {.usual = {.max_age = days(30)}}, kToday);
  EXPECT_THAT(names_of(deleted), ElementsAre("old", "on the day"));
}

TEST(Retention, the_oldest_are_deleted_until_a_room_has_no_more_than_it_may) {
  const auto deleted = outdated({recorded("3", 3, 40), recorded("1", 1, 40), recorded("2", 2, 40),
                                 recorded("other room", 9, 90, "attic")},
                                {.usual = {.max_bytes = 90}}, kToday);
  EXPECT_THAT(names_of(deleted), ElementsAre("3"));
}

TEST(Retention, a_room_may_have_limits_of_its_own) {
  const Retention retention = {
      .usual = {.max_age = days(30)},
      .rooms = {{"attic", {}}, {"hall", {.max_age = days(7), .max_bytes = 90}}}};
  const auto deleted =
      outdated({recorded("lab", 31, 1), recorded("attic", 9'000, 1ULL << 50, "attic"),
                recorded("hall old", 8, 1, "hall"), recorded("hall large", 2, 60, "hall"),
                recorded("hall new", 1, 60, "hall")},
               retention, kToday);
  EXPECT_THAT(names_of(deleted), ElementsAre("lab", "hall old", "hall large"));
  EXPECT_TRUE((Retention{.usual = {}, .rooms = {{"hall", {.max_age = days(1)}}}}.any()));
  EXPECT_FALSE((Retention{.usual = {}, .rooms = {{"attic", {}}}}.any()));
}

TEST(Retention, both_limits_count_together) {
  const auto deleted = outdated({recorded("a", 40, 60), recorded("b", 2, 60), recorded("c", 1, 30)},
                                {.usual = {.max_age = days(30), .max_bytes = 90}}, kToday);
  EXPECT_THAT(names_of(deleted), ElementsAre("a")) << "the rest is within the limit then";
}

TEST(Retention, a_recording_that_runs_counts_and_is_kept) {
  AgingRecording running = recorded("running", 0, 100);
  running.running = true;
  const auto deleted =
      outdated({running, recorded("a", 1, 10)}, {.usual = {.max_bytes = 50}}, kToday);
  EXPECT_THAT(names_of(deleted), ElementsAre("a"));
}

TEST(Retention, files_that_name_no_room_are_kept) {
  EXPECT_THAT(outdated({recorded("foreign", 900, 1ULL << 40, "")},
                       {.usual = {.max_age = days(1), .max_bytes = 1}}, kToday),
              IsEmpty());
}

}  // namespace
}  // namespace roomcast::hub::daemon
