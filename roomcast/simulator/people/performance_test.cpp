// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/performance.h"

#include <cmath>

#include <gtest/gtest.h>

namespace roomcast::simulator {
namespace {

using Eigen::Isometry3f;
using Eigen::Vector3f;

constexpr float kSlide_m = 0.01F;
constexpr double kFrame_s = 1.0 / 30.0;

/// Walks between a shelf and a bench, turns at both, and carries a box there and back.
Person carrier() {
  Person person;
  person.burden.emplace();
  person.burden->half_size_m = {0.2F, 0.15F, 0.12F};
  Waypoint shelf, bench;
  shelf.at_m = {-1.2F, -0.8F};
  shelf.heading_rad = -1.57F;
  shelf.stay_s = 3.0F;
  shelf.target_m = {-1.65F, 0.9F, -0.8F};
  bench.at_m = {1.0F, 0.9F};
  bench.heading_rad = 0.0F;
  bench.stay_s = 3.0F;
  bench.target_m = {1.0F, 0.92F, 1.35F};
  bench.via_m = {{0.1F, -0.3F}};
  Waypoint take = shelf, leave = bench, take_back = bench, leave_back = shelf;
  take_back.via_m.clear();
  take.activity = take_back.activity = Activity::kTakeUp;
  leave.activity = leave_back.activity = Activity::kPutDown;
  person.stops = {take, leave, take_back, leave_back};
  return person;
}

Person sitter() {
  Person person;
  Waypoint door, chair;
  door.at_m = {1.5F, 0.0F};
  chair.at_m = {-0.5F, 0.42F};
  chair.seat_m = {-0.5F, 0.46F, 0.0F};
  chair.activity = Activity::kSit;
  chair.stay_s = 6.0F;
  person.stops = {door, chair};
  return person;
}

/// Exercises, walks back and stretches.
Person exerciser() {
  Person person;
  Waypoint front, back;
  front.at_m = {0.0F, 0.4F};
  front.activity = Activity::kExercise;
  front.stay_s = 6.0F;
  back.at_m = {0.2F, -0.5F};
  back.activity = Activity::kStretch;
  back.stay_s = 6.0F;
  person.stops = {front, back};
  return person;
}

template <class Check>
void over_a_round(const Performance& performance, const Check& check) {
  const double end_s = performance.itinerary().period_s();
  for (double time_s = 0; time_s < end_s; time_s += kFrame_s) check(time_s);
}

TEST(Performance, planted_feet_do_not_slide) {
  for (const Person& person : {carrier(), sitter(), exerciser()}) {
    const Performance performance(person);
    for (const Side side : kSides) {
      Vector3f planted_at = Vector3f::Zero();
      bool was_planted = false;
      Vector3f was_pivot = Vector3f::Zero();
      over_a_round(performance, [&](double time_s) {
        const auto foot = performance.footsteps().foot_at(performance.round_time(time_s), side);
        const Bone bone = on_side(Bone::kLeftFoot, side);
        const Vector3f sole = performance.at(time_s).pose.of(bone) * foot.pivot_m;
        const bool same_stance = foot.planted && was_planted && was_pivot == foot.pivot_m;
        if (same_stance) {
          EXPECT_LT((sole - planted_at).norm(), kSlide_m) << time_s;
        }
        if (!same_stance) planted_at = sole;
        was_planted = foot.planted;
        was_pivot = foot.pivot_m;
      });
    }
  }
}

TEST(Performance, soles_stay_on_or_above_the_floor_and_one_foot_is_always_down) {
  const Performance performance(carrier());
  over_a_round(performance, [&](double time_s) {
    bool down = false;
    for (const Side side : kSides) {
      const auto foot = performance.footsteps().foot_at(performance.round_time(time_s), side);
      down = down || foot.planted;
      const Isometry3f ankle = performance.at(time_s).pose.of(on_side(Bone::kLeftFoot, side));
      const float drop = performance.measures().ankle;
      for (const float z : {-0.055F, 0.125F})
        EXPECT_GT((ankle * Vector3f(0, -drop, z)).y(), -0.005F) << time_s;
      if (foot.planted) {
        EXPECT_NEAR((ankle * foot.pivot_m).y(), 0.0F, 0.005F) << time_s;
      }
    }
    EXPECT_TRUE(down) << time_s;
  });
}

TEST(Performance, limbs_keep_their_lengths) {
  const Performance performance(carrier());
  const Measures& m = performance.measures();
  over_a_round(performance, [&](double time_s) {
    const Pose pose = performance.at(time_s).pose;
    const auto apart = [&](Bone a, Bone b) {
      return (pose.of(a).translation() - pose.of(b).translation()).norm();
    };
    for (const Side side : kSides) {
      const Bone elbow = on_side(Bone::kLeftForearm, side);
      const Bone knee = on_side(Bone::kLeftShin, side);
      EXPECT_NEAR(apart(on_side(Bone::kLeftUpperArm, side), elbow), m.upper_arm, 1e-3F);
      EXPECT_NEAR(apart(elbow, on_side(Bone::kLeftHand, side)), m.forearm, 1e-3F);
      EXPECT_NEAR(apart(on_side(Bone::kLeftThigh, side), knee), m.thigh, 1e-3F);
      EXPECT_NEAR(apart(knee, on_side(Bone::kLeftFoot, side)), m.shin, 1e-3F);
    }
  });
}

TEST(Performance, both_palms_are_at_the_burden_while_it_is_carried) {
  const Person person = carrier();
  const Performance performance(person);
  int carried = 0;
  over_a_round(performance, [&](double time_s) {
    const auto now = performance.at(time_s);
    if (now.held < 1.0F) return;
    ++carried;
    for (const Side side : kSides) {
      const Isometry3f& hand = now.pose.of(on_side(Bone::kLeftHand, side));
      const Vector3f palm = hand * palm_in_hand(side, performance.measures());
      const Vector3f grip = now.world_from_burden * Performance::grip(*person.burden, side);
      EXPECT_LT((palm - grip).norm(), 0.01F) << time_s;
    }
  });
  EXPECT_GT(carried, 100);
}

TEST(Performance, the_burden_stays_at_its_place_and_never_jumps) {
  const Person person = carrier();
  const Performance performance(person);
  Vector3f last = performance.at(-kFrame_s).world_from_burden.translation();
  over_a_round(performance, [&](double time_s) {
    const auto now = performance.at(time_s);
    const Vector3f here = now.world_from_burden.translation();
    EXPECT_LT((here - last).norm(), 0.08F) << time_s;
    last = here;
    if (now.held > 0.0F) return;
    const float to_shelf = (here - person.stops[0].target_m).norm();
    const float to_bench = (here - person.stops[1].target_m).norm();
    EXPECT_LT(std::min(to_shelf, to_bench), 1e-4F) << time_s;
  });
}

TEST(Performance, nothing_jumps_from_frame_to_frame_nor_where_the_round_begins_again) {
  constexpr float kFastest_m = 0.16F;  // limit for a swinging foot or hand in 1/30 s
  for (const Person& person : {carrier(), sitter(), exerciser()}) {
    const Performance performance(person);
    Pose last = performance.at(-kFrame_s).pose;
    over_a_round(performance, [&](double time_s) {
      const Pose pose = performance.at(time_s).pose;
      for (std::size_t bone = 0; bone < kBoneCount; ++bone) {
        const Vector3f way =
            pose.world_from_bone[bone].translation() - last.world_from_bone[bone].translation();
        EXPECT_LT(way.norm(), kFastest_m) << "bone " << bone << " at " << time_s;
      }
      last = pose;
    });
  }
}

TEST(Performance, a_sitting_person_has_the_hips_over_the_seat) {
  const Person person = sitter();
  const Performance performance(person);
  float nearest = 10.0F;
  over_a_round(performance, [&](double time_s) {
    const Vector3f hips = performance.at(time_s).pose.of(Bone::kPelvis).translation();
    nearest = std::min(nearest, (hips - person.stops[1].seat_m).norm());
  });
  EXPECT_LT(nearest, 0.11F);
}

TEST(Performance, the_right_palm_reaches_plugs_high_and_low) {
  for (const float height_m : {0.35F, 0.8F, 1.1F}) {
    Person person;
    Waypoint stop;
    stop.activity = Activity::kPlug;
    stop.stay_s = 5.0F;
    stop.target_m = {0.0F, height_m, 0.55F};
    person.stops = {stop};
    const Performance performance(person);
    const auto now = performance.at(1.0);
    const Vector3f palm =
        now.pose.of(Bone::kRightHand) * palm_in_hand(Side::kRight, performance.measures());
    EXPECT_LT((palm - stop.target_m).norm(), 0.03F) << height_m;
  }
}

TEST(Performance, exercise_goes_down_and_swings_both_hands_above_the_head) {
  const Performance performance(exerciser());
  float lowest = 10.0F, highest = 0.0F;
  float left_above = 0.0F, right_above = 0.0F;
  over_a_round(performance, [&](double time_s) {
    const Pose pose = performance.at(time_s).pose;
    const float hips = pose.of(Bone::kPelvis).translation().y();
    lowest = std::min(lowest, hips);
    highest = std::max(highest, hips);
    const float head = pose.of(Bone::kHead).translation().y();
    left_above = std::max(left_above, pose.of(Bone::kLeftHand).translation().y() - head);
    right_above = std::max(right_above, pose.of(Bone::kRightHand).translation().y() - head);
  });
  EXPECT_GT(highest - lowest, 0.15F);
  EXPECT_GT(left_above, 0.0F);
  EXPECT_GT(right_above, 0.0F);
}

}  // namespace
}  // namespace roomcast::simulator
