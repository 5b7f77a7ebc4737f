// SPDX-License-Identifier: Apache-2.0
#include "roomcast/study/session_path.h"

#include <cmath>

#include <gtest/gtest.h>

#include "roomcast/study/study_fixture.h"

namespace roomcast::study {
namespace {

using namespace std::chrono_literals;

constexpr const char* kSeenPlan = R"([study]
name = "s"
consent = "yes"
order = "fixed"
[[condition]]
name = "live"
[[condition]]
name = "late"
latency_ms = 500
mode = "points"
)";

class SessionPathTest : public StudyFixture {
 protected:
  static nlohmann::json pose(double t, double x, double yaw_rad) {
    return {{"kind", "poses"},
            {"t", t},
            {"x", x},
            {"y", 1.6},
            {"z", 2},
            {"qx", 0},
            {"qy", std::sin(yaw_rad / 2)},
            {"qz", 0},
            {"qw", std::cos(yaw_rad / 2)}};
  }
  StudyFolder went_through() {
    auto study = create_from(kSeenPlan);
    (void)study.enroll(plan, "k", kNow);
    (void)study.append("P001", 1,
                       {step(10, 0, "live", true), pose(10.1, 1, 0), pose(10.1, 9, 0),
                        pose(11, 2, M_PI / 2), step(16, 0, "live", false), pose(17, 5, 0),
                        step(20, 1, "late", true), pose(21, 3, 0), step(26, 1, "late", false)});
    return study;
  }
};

TEST_F(SessionPathTest, is_that_of_the_head_in_the_time_of_the_recording) {
  const auto seen = seen_conditions(went_through(), "P001", kNow - 100s, 1h);
  ASSERT_TRUE(seen.ok()) << seen.error().message;
  ASSERT_EQ(seen->size(), 2u);
  const SeenCondition& live = seen->front();
  EXPECT_EQ(live.name, "live");
  EXPECT_NEAR(live.from_s, 110, 1e-6);
  EXPECT_NEAR(live.to_s, 116, 1e-6);
  ASSERT_EQ(live.keys.size(), 2u);  // times increase
  EXPECT_NEAR(live.keys[0].time_s, 0.1, 1e-6);
  EXPECT_NEAR(live.keys[0].look_m[2] - live.keys[0].at_m[2], -2, 1e-9);
  EXPECT_NEAR(live.keys[1].look_m[0] - live.keys[1].at_m[0], -2, 1e-9);  // turned to the left
  EXPECT_NEAR(live.keys[1].look_m[2] - live.keys[1].at_m[2], 0, 1e-9);
}

TEST_F(SessionPathTest, shows_what_was_seen_late_as_it_was_then) {
  const auto seen = seen_conditions(went_through(), "P001", kNow, 1h);
  ASSERT_TRUE(seen.ok());
  const SeenCondition& late = seen->at(1);
  EXPECT_NEAR(late.from_s, 19.5, 1e-6);
  EXPECT_NEAR(late.to_s, 25.5, 1e-6);
  EXPECT_NEAR(late.keys[0].time_s, 1, 1e-6);
  EXPECT_EQ(late.mode, "points");
}

TEST_F(SessionPathTest, leaves_out_what_was_not_recorded) {
  const auto study = went_through();
  const auto seen = seen_conditions(study, "P001", kNow, 18s);
  ASSERT_TRUE(seen.ok());
  EXPECT_EQ(seen->size(), 1u);
  const auto part = seen_conditions(study, "P001", kNow + 10500ms, 3s);  // of the first one
  ASSERT_TRUE(part.ok());
  ASSERT_EQ(part->size(), 1u);
  EXPECT_NEAR(part->front().from_s, 0, 1e-6);
  EXPECT_NEAR(part->front().to_s, 3, 1e-6);
  EXPECT_EQ(seen_conditions(study, "P001", kNow + 1h, 1h).error().code, ErrorCode::kNotFound);
  EXPECT_EQ(seen_conditions(study, "P009", kNow, 1h).error().code, ErrorCode::kNotFound);
}

TEST_F(SessionPathTest, is_a_path_for_films) {
  const auto json =
      nlohmann::json::parse(path_json({{.time_s = 1, .at_m = {1, 2, 3}, .look_m = {4, 5, 6}}}));
  EXPECT_EQ(json["keys"][0]["at"][1], 2);
  EXPECT_EQ(json["keys"][0]["look"][2], 6);
}

}  // namespace
}  // namespace roomcast::study
