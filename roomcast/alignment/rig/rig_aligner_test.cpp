// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/rig/rig_aligner.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/alignment/feature/views_fixture.h"
#include "roomcast/alignment/pair/pose_difference.h"

namespace roomcast::alignment {
namespace {

constexpr double kMaxAngle_rad = 0.3 * M_PI / 180, kMaxError_m = 0.015;

const std::vector<const ViewFixture*>& corner_views() {
  static const std::vector<const ViewFixture*> views = {&first_corner(), &second_corner(),
                                                        &third_corner()};
  return views;
}

AlignmentReport align_corners() {
  RigAligner aligner;
  for (const ViewFixture* view : corner_views()) aligner.add(view->view);
  return aligner.solve();
}

const AlignmentReport& corners_report() {
  static const AlignmentReport report = align_corners();
  return report;
}

TEST(RigAligner, places_three_corners_of_a_room) {
  const AlignmentReport& report = corners_report();
  ASSERT_EQ(report.sensors.size(), 3u);
  for (const SensorReport& sensor : report.sensors) {
    ASSERT_TRUE(sensor.placed) << sensor.id << ": " << sensor.reason;
  }
  for (std::size_t i = 1; i < 3; ++i) {
    const RigidTransform found =
        report.sensors[0].world_from_depth->inverse() * *report.sensors[i].world_from_depth;
    const PoseDifference error =
        difference(found, true_pose(*corner_views()[0], *corner_views()[i]));
    EXPECT_LT(error.angle_rad, kMaxAngle_rad) << report.sensors[i].id;
    EXPECT_LT(error.distance_m, kMaxError_m) << report.sensors[i].id;
  }
}

TEST(RigAligner, puts_the_floor_at_zero_and_y_up) {
  const AlignmentReport& report = corners_report();
  EXPECT_TRUE(report.has_floor);
  for (std::size_t i = 0; i < 3; ++i) {
    const RigidTransform& found = *report.sensors[i].world_from_depth;
    const RigidTransform& truth = corner_views()[i]->world_from_depth;
    EXPECT_NEAR(found.translation_m.y(), truth.translation_m.y(), kMaxError_m);
    EXPECT_GT(found.rotation.row(1).dot(truth.rotation.row(1)), std::cos(kMaxAngle_rad));
  }
  EXPECT_NEAR(report.sensors[0].world_from_depth->translation_m.x(), 0, 1e-9);
  EXPECT_LT((report.sensors[0].world_from_depth->rotation * Eigen::Vector3d::UnitZ()).z(), 0);
}

TEST(RigAligner, reports_every_pair) {
  const AlignmentReport& report = corners_report();
  ASSERT_EQ(report.pairs.size(), 3u);
  for (const PairReport& pair : report.pairs) EXPECT_FALSE(pair.reason.empty());
  EXPECT_TRUE(report.pairs[0].accepted);
  EXPECT_LT(report.pairs[0].residual_mm, 5);
  EXPECT_GT(report.pairs[0].overlap, 0.1);
  EXPECT_GT(report.pairs[0].inliers, 12);
  EXPECT_GT(report.pairs[0].expected_error_mm, 1);
  EXPECT_LT(report.pairs[0].expected_error_mm, 30);
}

TEST(RigAligner, reports_what_each_sensor_shares) {
  for (const SensorReport& sensor : corners_report().sensors) {
    EXPECT_GT(sensor.overlap, 0.1) << sensor.id;
    EXPECT_GT(sensor.inliers, 12) << sensor.id;
    EXPECT_GT(sensor.residual_mm, 0) << sensor.id;
    EXPECT_LT(sensor.residual_mm, 5) << sensor.id;
  }
}

TEST(RigAligner, gives_the_same_bits_every_time) {
  const AlignmentReport again = align_corners();
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(row_major_from_transform(*again.sensors[i].world_from_depth),
              row_major_from_transform(*corners_report().sensors[i].world_from_depth));
  }
}

TEST(RigAligner, does_not_place_a_sensor_of_another_room) {
  RoomFixture elsewhere;
  elsewhere.looks = 7;
  elsewhere.boxes = {{Eigen::Vector3d(0.5, 0, -1), Eigen::Vector3d(1.5, 1.2, 0)}};
  const ViewFixture stranger = view_fixture(elsewhere, "far", corner_pose(-2, 1.5));
  RigAligner aligner;
  aligner.add(first_corner().view);
  aligner.add(second_corner().view);
  aligner.add(stranger.view);
  const AlignmentReport report = aligner.solve();
  EXPECT_TRUE(report.sensors[0].placed);
  EXPECT_TRUE(report.sensors[1].placed);
  EXPECT_FALSE(report.sensors[2].placed);
  EXPECT_FALSE(report.sensors[2].world_from_depth.has_value());
  EXPECT_THAT(report.sensors[2].reason, testing::HasSubstr("far"));
}

TEST(RigAligner, sensors_that_share_nothing_stay_apart) {
  const RigidTransform one_way = world_from_optical_looking_at({0, 2, 1}, {2.5, 1.8, 1.9});
  const RigidTransform other_way = world_from_optical_looking_at({0, 2, -1}, {-2.5, 1.8, -1.9});
  RigAligner aligner;
  aligner.add(view_fixture({}, "east", one_way).view);
  aligner.add(view_fixture({}, "west", other_way).view);
  const AlignmentReport report = aligner.solve();
  EXPECT_FALSE(report.sensors[0].placed);
  EXPECT_FALSE(report.sensors[1].placed);
  EXPECT_FALSE(report.pairs[0].accepted);
  EXPECT_FALSE(report.pairs[0].b_from_a.has_value());
}

TEST(RigAligner, is_not_fooled_by_a_room_that_looks_the_same_turned_by_half) {
  RigAligner aligner;
  aligner.add(one_side().view);
  aligner.add(other_side().view);
  const auto b_from_a = aligner.solve().pairs[0].b_from_a;
  if (!b_from_a) return;  // refused, which is acceptable
  const PoseDifference error = difference(b_from_a->inverse(), true_pose(one_side(), other_side()));
  EXPECT_LT(error.angle_rad, kMaxAngle_rad);
  EXPECT_LT(error.distance_m, kMaxError_m);
}

/// A view whose depth errors are a smooth wave over the picture, another one for every phase.
std::shared_ptr<const SensorView> view_of_flawed_unit(const ViewFixture& exact, double phase) {
  constexpr double kWave_mm = 5;
  CalibrationBundle bundle = bundle_fixture({}, exact.view->name, exact.world_from_depth);
  for (int y = 0; y < bundle.depth_mm.height(); ++y) {
    for (int x = 0; x < bundle.depth_mm.width(); ++x) {
      const double wave = std::sin(0.04 * x + phase) * std::cos(0.05 * y + 2 * phase);
      bundle.depth_mm.at(x, y) += static_cast<std::uint16_t>(std::lround(kWave_mm * (1 + wave)));
    }
  }
  auto view = make_sensor_view(bundle);
  ROOMCAST_ASSERT(view.ok());
  return std::make_shared<const SensorView>(std::move(*view));
}

TEST(RigAligner, expects_about_the_errors_that_flawed_depth_makes) {
  RigAligner aligner;
  double phase = 0;
  for (const ViewFixture* view : corner_views())
    aligner.add(view_of_flawed_unit(*view, phase += 1));
  const AlignmentReport report = aligner.solve();
  EXPECT_EQ(report.sensors[0].expected_error_mm, 0) << "stands at the origin";
  for (std::size_t i = 1; i < 3; ++i) {
    const SensorReport& sensor = report.sensors[i];
    ASSERT_TRUE(sensor.placed);
    const PoseDifference error =
        difference(report.sensors[0].world_from_depth->inverse() * *sensor.world_from_depth,
                   true_pose(*corner_views()[0], *corner_views()[i]));
    EXPECT_LT(1000 * error.distance_m, 2 * sensor.expected_error_mm);
    EXPECT_LT(error.angle_rad * 180 / M_PI, 2 * sensor.expected_error_deg);
    // Surfaces that disagree by millimetres raise doubts about the scale, too (ADR 18).
    EXPECT_LT(sensor.expected_error_mm, 200) << "nor is it a worthless bound";
  }
}

TEST(RigAligner, a_copy_of_a_sensor_is_not_placed) {
  RigAligner aligner;
  aligner.add(first_corner().view);
  aligner.add(view_fixture({}, "copy", first_corner().world_from_depth).view);
  const AlignmentReport report = aligner.solve();
  EXPECT_FALSE(report.sensors[1].placed);
  EXPECT_THAT(report.sensors[1].reason, testing::HasSubstr("very same pictures"));
}

/// Aligns two sensors of a room with a third one of a room that has another poster on a wall.
AlignmentReport with_a_stranger(const Eigen::AlignedBox3d& poster) {
  RoomFixture other_room;
  other_room.repainted = poster;
  RigAligner aligner;
  aligner.add(first_corner().view);
  aligner.add(second_corner().view);
  aligner.add(view_fixture(other_room, "stranger", corner_pose(1.6, 1.5)).view);
  return aligner.solve();
}

TEST(RigAligner, a_sensor_of_a_room_with_another_poster_is_not_placed) {
  for (const double half_m : {1.5, 0.6}) {
    const AlignmentReport report =
        with_a_stranger({Eigen::Vector3d(-half_m, 1.1, -2.1), Eigen::Vector3d(half_m, 2.3, -1.9)});
    EXPECT_TRUE(report.sensors[0].placed);
    EXPECT_TRUE(report.sensors[1].placed);
    EXPECT_FALSE(report.sensors[2].placed) << half_m;
  }
}

TEST(RigAligner, a_sensor_can_leave_and_another_join) {
  RigAligner aligner;
  aligner.add(first_corner().view);
  aligner.add(third_corner().view);
  (void)aligner.solve();
  aligner.remove("s2");
  aligner.add(second_corner().view);
  const AlignmentReport report = aligner.solve();
  ASSERT_EQ(report.sensors.size(), 2u);
  EXPECT_EQ(report.sensors[1].id, "s1");
  EXPECT_TRUE(report.sensors[1].placed);
}

TEST(RigAligner, tells_how_far_it_is) {
  RigAligner aligner;
  for (const ViewFixture* view : corner_views()) aligner.add(view->view);
  std::vector<double> done;
  (void)aligner.solve([&](std::string_view step, double share) {
    EXPECT_FALSE(step.empty());
    done.push_back(share);
  });
  EXPECT_GE(done.size(), 4u);
  EXPECT_TRUE(std::is_sorted(done.begin(), done.end()));
}

TEST(RigAligner, looks_closer_at_pairs_of_sensors_that_would_be_refused_and_once_only) {
  RoomFixture elsewhere;
  elsewhere.looks = 7;
  RigAligner aligner;
  aligner.add(first_corner().view);
  aligner.add(second_corner().view);
  std::vector<std::string> closer;
  const AlignProgress listen = [&](std::string_view step, double) {
    if (step.ends_with(" again")) closer.emplace_back(step);
  };
  (void)aligner.solve(listen);
  EXPECT_THAT(closer, testing::IsEmpty());
  aligner.add(view_fixture(elsewhere, "far", corner_pose(-2, 1.5)).view);
  (void)aligner.solve(listen);
  EXPECT_THAT(closer,
              testing::ElementsAre("matching s0 and far again", "matching s1 and far again"));
  (void)aligner.solve(listen);
  EXPECT_EQ(closer.size(), 2u);
}

TEST(RigAligner, nobody_or_one_alone_is_no_trouble) {
  RigAligner aligner;
  EXPECT_TRUE(aligner.solve().sensors.empty());
  aligner.add(first_corner().view);
  const AlignmentReport alone = aligner.solve();
  ASSERT_EQ(alone.sensors.size(), 1u);
  EXPECT_TRUE(alone.sensors[0].placed);
  EXPECT_TRUE(alone.has_floor);
}

}  // namespace
}  // namespace roomcast::alignment
