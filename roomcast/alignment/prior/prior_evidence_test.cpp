// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/prior/prior_evidence.h"

#include <array>

#include <gtest/gtest.h>

#include "roomcast/alignment/pair/wall_matches_fixture.h"

namespace roomcast::alignment {
namespace {

/// Evidence of a pose that nothing contradicts.
PoseEvidence harmless_evidence() {
  PoseEvidence evidence;
  evidence.space.consistent = 0.4;
  evidence.space.min_consistent = 0.3;
  evidence.photo = {0.2, 0.8};
  return evidence;
}

TEST(PriorEvidence, of_a_fitting_pose_contradicts_nothing) {
  EXPECT_EQ(contradiction(harmless_evidence()), Contradiction::kNone);
}

TEST(PriorEvidence, surfaces_in_free_space_contradict) {
  PoseEvidence evidence = harmless_evidence();
  // Of consistent and violating points 7 % and 9 %; 8 % are allowed.
  evidence.space.violating = 0.4 * 0.07 / 0.93;
  EXPECT_FALSE(has_free_space_conflict(evidence.space));
  EXPECT_EQ(contradiction(evidence), Contradiction::kNone);
  evidence.space.violating = 0.4 * 0.09 / 0.91;
  EXPECT_TRUE(has_free_space_conflict(evidence.space));
  EXPECT_EQ(contradiction(evidence), Contradiction::kShapes);
}

TEST(PriorEvidence, views_that_hardly_overlap_do_not_confirm) {
  PoseEvidence evidence = harmless_evidence();
  evidence.space.min_consistent = 0.051;
  EXPECT_EQ(contradiction(evidence), Contradiction::kNone);
  evidence.space.min_consistent = 0.049;
  EXPECT_EQ(contradiction(evidence), Contradiction::kShapes);
}

TEST(PriorEvidence, other_colours_contradict_where_there_is_texture) {
  PoseEvidence evidence = harmless_evidence();
  evidence.photo = {0.2, 0.36};
  EXPECT_EQ(contradiction(evidence), Contradiction::kNone);
  evidence.photo = {0.2, 0.34};
  EXPECT_EQ(contradiction(evidence), Contradiction::kColors);
  evidence.photo = {0.003, 0};  // too little texture to tell
  EXPECT_EQ(contradiction(evidence), Contradiction::kNone);
}

TEST(BestPartner, is_the_placed_sensor_that_shares_most_at_the_prior) {
  const SensorView view = wall_view({}, 1), near = wall_view({}, 0.5), far = wall_view({}, -0.5);
  const PlacedView with_much{&near, wall_pose(0, 0.5)}, with_less{&far, wall_pose(0, -0.5)};
  const RigidTransform prior = wall_pose(0, 1);
  for (const auto& others : {std::array{with_much, with_less}, std::array{with_less, with_much}}) {
    const auto partner = best_partner(view, prior, others);
    ASSERT_TRUE(partner.has_value());
    EXPECT_EQ(partner->view, &near);
    EXPECT_EQ(partner->world_from_depth.translation_m.x(), 0.5);
  }
}

TEST(BestPartner, is_found_by_a_prior_that_is_off_by_decimetres) {
  // All of the wall violates free space then, but it is the same wall.
  const SensorView view = wall_view({}, 0), other = wall_view({}, 0.5);
  RigidTransform prior;
  prior.translation_m.z() = 0.3;
  const std::array<PlacedView, 1> others = {{{&other, wall_pose(0, 0.5)}}};
  EXPECT_TRUE(best_partner(view, prior, others).has_value());
}

TEST(BestPartner, is_none_where_nothing_is_shared) {
  const SensorView view = wall_view({}, 0), other = wall_view({}, 4);
  const std::array<PlacedView, 1> others = {{{&other, wall_pose(0, 4)}}};
  EXPECT_FALSE(best_partner(view, {}, others).has_value());
  EXPECT_FALSE(best_partner(view, {}, {}).has_value());
}

/// A wall's view with features every 20 cm, each with its own descriptor: that of its place.
SensorView view_with_known_features(double x_m) {
  SensorView view = wall_view({}, x_m);
  for (int row = -4; row <= 4; ++row) {
    for (int column = -6; column <= 12; ++column) {
      const Eigen::Vector3f point_m(static_cast<float>(0.2 * column - x_m),
                                    0.2F * static_cast<float>(row), 2);
      if (std::abs(point_m.x()) > 1.3F) continue;
      Descriptor descriptor{};
      const auto number = static_cast<std::size_t>(19 * (row + 4) + column + 6);
      descriptor[number % kDescriptorSize] = 362;  // two bins, 512 / sqrt(2) each
      descriptor[(3 * number + 1 + number / kDescriptorSize) % kDescriptorSize] = 362;
      view.picture_features.features.push_back({point_m, view.picture.pixel_of(point_m)});
      view.picture_features.descriptors.push_back(descriptor);
    }
  }
  return view;
}

TEST(PriorCandidates, of_a_pair_hold_its_true_pose) {
  const SensorView a = view_with_known_features(0), b = view_with_known_features(0.6);
  const PairCandidates candidates = candidates_of(a, b);
  ASSERT_FALSE(candidates.ranked().empty());
  EXPECT_LT((candidates.ranked()[0].a_from_b.translation_m - Eigen::Vector3d(0.6, 0, 0)).norm(),
            0.01);
  EXPECT_EQ(contradiction(candidates.ranked()[0]), Contradiction::kNone);
}

}  // namespace
}  // namespace roomcast::alignment
