// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/uplink_share.h"

#include <algorithm>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/net/socket_tuning.h"

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;
using testing::DoubleNear;
using testing::ElementsAre;

constexpr SensorId kLeft{0}, kRight{1}, kThird{2};

RoomTime share_time(nanoseconds time) {
  return RoomTime(1h + time);
}

TEST(DivideRate, is_proportional_between_the_limits_of_each) {
  EXPECT_THAT(divide_rate(6, {1, 2}, 0.1, {0, 0}), ElementsAre(2, 4));
  EXPECT_THAT(divide_rate(6, {1, 2}, 0.1, {0, 1}), ElementsAre(5, 1));
  EXPECT_THAT(divide_rate(1, {1, 999}, 0.1, {0, 0}), ElementsAre(0.1, 0.9));
  EXPECT_THAT(divide_rate(6, {1, 1}, 0.1, {1, 1}), ElementsAre(1, 1)) << "the rest is unused";
}

TEST(DivideRate, too_little_for_all_is_the_least_for_each) {
  EXPECT_THAT(divide_rate(0.15, {1, 2}, 0.1, {0, 0}), ElementsAre(0.1, 0.1));
  EXPECT_THAT(divide_rate(-1, {1, 2}, 0.1, {0, 0}), ElementsAre(0.1, 0.1));
  EXPECT_THAT(divide_rate(5, {}, 0.1, {}), ElementsAre());
}

/// Sensors that use all of their shares.
class UplinkShareTest : public testing::Test {
 protected:
  void update(nanoseconds time, std::vector<UplinkUser> users, double mbit = 6) {
    const double seconds = std::chrono::duration<double>(time - last_time).count();
    last_time = time;
    for (UplinkUser& user : users) {
      if (!user.follows) continue;
      sent_bytes[user.sensor] += seconds * shares.of(user.sensor) / net::line_mbit_per_s(1);
      user.sent_bytes = static_cast<std::uint64_t>(sent_bytes[user.sensor]);
    }
    shares.update(mbit, users, share_time(time));
  }
  nanoseconds last_time = 0s;
  std::map<SensorId, double> sent_bytes;
  UplinkShare shares;
};

TEST_F(UplinkShareTest, sensors_that_all_see_share_evenly) {
  update(0s, {{.sensor = kLeft}, {.sensor = kRight}});
  EXPECT_EQ(shares.of(kLeft), 3);
  EXPECT_EQ(shares.of(kRight), 3);
  EXPECT_EQ(shares.of(kThird), 0) << "it is not there";
}

TEST_F(UplinkShareTest, without_a_limit_there_are_no_shares) {
  update(0s, {{.sensor = kLeft}});
  update(1s, {{.sensor = kLeft}}, 0);
  EXPECT_EQ(shares.of(kLeft), 0);
  EXPECT_FALSE(shares.next());
}

TEST_F(UplinkShareTest, what_nobody_looks_at_loses_its_share_slowly_down_to_a_fifth) {
  update(0s, {{.sensor = kLeft}, {.sensor = kRight}});
  double before = shares.of(kRight);
  for (auto time = 500ms; time <= 10s; time += 500ms) {
    update(time, {{.sensor = kLeft}, {.sensor = kRight, .importance = 0}});
    EXPECT_LE(shares.of(kRight), before);
    EXPECT_GT(shares.of(kRight), 0.7 * before) << "slowly";
    EXPECT_NEAR(shares.of(kLeft) + shares.of(kRight), 6, 1e-9);
    before = shares.of(kRight);
  }
  EXPECT_NEAR(before, 6.0 / 5, 0.15);
  update(11s, {{.sensor = kLeft}, {.sensor = kRight}});
  EXPECT_EQ(shares.of(kRight), 3) << "and has it back at once";
}

TEST_F(UplinkShareTest, small_changes_are_not_worth_telling) {
  update(0s, {{.sensor = kLeft}, {.sensor = kRight}});
  update(20s, {{.sensor = kLeft}, {.sensor = kRight, .importance = 0.95}});
  EXPECT_EQ(shares.of(kRight), 3);
}

TEST_F(UplinkShareTest, a_viewer_who_looks_to_and_fro_does_not_make_shares_swing) {
  int changes = 0;
  double before = 0;
  for (int i = 0; i < 40; ++i) {
    const bool is_left = i % 2 == 0;
    update(i * 500ms, {{.sensor = kLeft, .importance = is_left ? 1.0 : 0.3},
                       {.sensor = kRight, .importance = is_left ? 0.3 : 1.0}});
    if (shares.of(kLeft) != before) ++changes;
    before = shares.of(kLeft);
  }
  EXPECT_LE(changes, 3);
  EXPECT_NEAR(before, 3, 0.4);
}

TEST_F(UplinkShareTest, a_sensor_that_sends_nothing_leaves_its_share_at_once) {
  update(0s, {{.sensor = kLeft}, {.sensor = kRight}});
  update(100ms, {{.sensor = kLeft}, {.sensor = kRight, .is_paused = true}});
  EXPECT_EQ(shares.of(kLeft), 6);
  EXPECT_EQ(shares.of(kRight), 0);
  update(200ms, {{.sensor = kLeft}, {.sensor = kRight}});
  EXPECT_EQ(shares.of(kLeft), 3);
}

TEST_F(UplinkShareTest, sensors_that_keep_to_no_share_leave_the_rest_to_the_others) {
  const auto at_2_mbit = [](nanoseconds time) {
    return static_cast<std::uint64_t>(std::chrono::duration<double>(time).count() * 2e6 / 8);
  };
  for (nanoseconds time = 0s; time <= 10s; time += 500ms) {
    update(time, {{.sensor = kLeft},
                  {.sensor = kThird, .follows = false, .sent_bytes = at_2_mbit(time)}});
  }
  EXPECT_THAT(shares.of(kLeft), DoubleNear(4, 0.4));
  EXPECT_EQ(shares.of(kThird), 0);
}

/// Sensors that send what they want to, within their shares.
class UplinkLendingTest : public testing::Test {
 protected:
  UplinkLendingTest() { run(0.1); }

  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds * 10); ++i) {
      time += 100ms;
      total = 0;
      for (std::size_t k = 0; k < users.size(); ++k) {
        users[k].sensor = SensorId{static_cast<std::uint16_t>(k)};
        const double mbit = std::min(wanted[k], shares.of(users[k].sensor));
        total += mbit;
        bytes[k] += 0.1 * mbit / net::line_mbit_per_s(1);
        users[k].sent_bytes = static_cast<std::uint64_t>(bytes[k]);
      }
      highest = std::max(highest, total);
      if (time - updated < 500ms) continue;
      updated = time;
      shares.update(kUplink, users, share_time(time));
    }
  }
  double share(std::size_t k) const { return shares.of(users[k].sensor); }

  static constexpr double kUplink = 6;
  std::vector<UplinkUser> users = std::vector<UplinkUser>(3);
  std::vector<double> wanted = {9, 9, 9}, bytes = {0, 0, 0};
  double total = 0, highest = 0;
  nanoseconds time = 0s, updated = -1s;
  UplinkShare shares;
};

TEST_F(UplinkLendingTest, what_calm_sensors_do_not_use_goes_to_the_one_that_does) {
  wanted = {9, 0.5, 0.2};
  run(8);
  EXPECT_GT(total, 0.95 * kUplink);
  EXPECT_NEAR(share(1), 0.625, 0.05) << "it has a little more than it uses";
  EXPECT_LE(highest, 1.001 * kUplink);
}

TEST_F(UplinkLendingTest, a_lender_that_wakes_has_its_even_share_within_a_second_and_a_half) {
  wanted = {9, 9, 0.5};
  run(10);
  EXPECT_GT(share(0), 2.5);
  highest = 0;
  wanted = {9, 9, 9};
  run(1.5);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(share(k), 2, 0.1);
  EXPECT_LT(highest, 1.03 * kUplink) << "meanwhile they send hardly more than the uplink's rate";
}

TEST_F(UplinkLendingTest, if_none_uses_all_each_may_use_what_is_left) {
  wanted = {3, 0.5, 0.2};
  run(12);
  EXPECT_NEAR(total, 3.7, 0.1);
  double all = 0;
  for (std::size_t k = 0; k < 3; ++k) all += share(k);
  EXPECT_NEAR(all, kUplink, 0.25);
  const double before = share(0);
  run(10);
  EXPECT_NEAR(share(0), before, 0.3) << "it does not swing";
}

TEST_F(UplinkLendingTest, a_sensor_that_just_came_lends_nothing_yet) {
  wanted = {9, 9, 0};
  run(1.5);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(share(k), 2, 0.1);
}

}  // namespace
}  // namespace roomcast::hub
