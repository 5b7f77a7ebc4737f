// SPDX-License-Identifier: Apache-2.0
#include "roomcast/alignment/board/board_match.h"

#include <random>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace roomcast::alignment {
namespace {

/// A tag held for a second at each of some places, turned a little each time.
class Hands {
 public:
  explicit Hands(std::size_t places, double apart_m = 0.5) : places_(places), apart_m_(apart_m) {}

  [[nodiscard]] std::vector<TagSighting> seen_from(const RigidTransform& world_from_sensor,
                                                   double phase_s, unsigned seed) const {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 0.004);
    std::vector<TagSighting> seen;
    for (double time_s = phase_s; time_s < static_cast<double>(places_); time_s += 0.11) {
      const RigidTransform sensor_from_board = world_from_sensor.inverse() * board_at(time_s);
      const Eigen::Vector3d off(noise(random), noise(random), noise(random));
      TagSighting& sighting = seen.emplace_back();
      sighting.time_s = time_s;
      constexpr double kHalf = 0.076;
      for (int i = 0; i < 4; ++i) {
        const Eigen::Vector3d corner(i == 0 || i == 3 ? -kHalf : kHalf, i < 2 ? -kHalf : kHalf, 0);
        sighting.corners_m[static_cast<std::size_t>(i)] = sensor_from_board * corner + off;
      }
    }
    return seen;
  }

 private:
  [[nodiscard]] RigidTransform board_at(double time_s) const {
    const int place = static_cast<int>(time_s);
    RigidTransform pose;
    pose.rotation =
        Eigen::AngleAxisd(0.4 * place, Eigen::Vector3d(0, 1, 0.3).normalized()).matrix();
    pose.translation_m = apart_m_ * Eigen::Vector3d(place % 3 - 1, 2 + place % 2, place / 3);
    return pose;
  }
  std::size_t places_;
  double apart_m_;
};

const RigidTransform kBoardSensor = world_from_optical_looking_at({-2.5, 2, 0}, {0, 1, 0});
const RigidTransform kOppositeSensor = world_from_optical_looking_at({2.4, 1.8, 0.5}, {0, 1, 0});

Result<BoardMatch> match_of_hands(const Hands& hands) {
  return match_boards(hands.seen_from(kBoardSensor, 0, 1),
                      hands.seen_from(kOppositeSensor, 0.04, 2));
}

TEST(BoardMatch, several_places_of_a_tag_place_the_sensors) {
  const auto found = match_of_hands(Hands(8));
  ASSERT_TRUE(found.ok()) << found.error().message;
  const RigidTransform truth = kBoardSensor.inverse() * kOppositeSensor;
  const Eigen::Vector3d ahead(0, 0, 2.5);
  EXPECT_LT((found->a_from_b * ahead - truth * ahead).norm(), 0.012);
  EXPECT_GT(found->expected_error_mm, 3);
  EXPECT_LT(found->expected_error_mm, 30);
}

TEST(BoardMatch, one_place_is_not_enough_however_long) {
  const auto found = match_boards(Hands(1).seen_from(kBoardSensor, 0, 1),
                                  Hands(1).seen_from(kOppositeSensor, 0.04, 2));
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().message.find("four places"), std::string::npos);
}

TEST(BoardMatch, places_close_together_are_not_enough) {
  EXPECT_FALSE(match_of_hands(Hands(8, 0.08)));
}

TEST(BoardMatch, two_boards_that_are_taken_for_one_are_refused) {
  EXPECT_FALSE(match_boards(Hands(8).seen_from(kBoardSensor, 0, 1),
                            Hands(8, 0.9).seen_from(kOppositeSensor, 0.04, 2)));
}

TEST(BoardMatch, nothing_seen_is_refused) {
  EXPECT_FALSE(match_boards({}, {}));
}

}  // namespace
}  // namespace roomcast::alignment
