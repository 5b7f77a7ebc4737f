// SPDX-License-Identifier: Apache-2.0
// Itinerary: a person's position on the floor at any time. The person turns on the spot, walks
// along a smooth path, turns, stays, and repeats this for all waypoints in a cycle. Speeds ramp up
// and down. A function of time alone. Metres, seconds, radians.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "roomcast/simulator/scene/person.h"

namespace roomcast::simulator {

class Itinerary {
 public:
  /// Needs at least one waypoint.
  Itinerary(std::span<const Waypoint> stops, float pace_m_s);

  struct Place {
    Eigen::Vector2f at_m;
    float heading_rad;
    float speed_m_s;
  };
  /// Any time is allowed; repeats with the period.
  [[nodiscard]] Place place_at(float time_s) const;

  /// A waypoint with the elapsed and remaining time of the stay; both are large if there is only
  /// one.
  struct Stay {
    std::size_t stop;
    float since_s, left_s;
  };
  /// Nothing while turning or walking.
  [[nodiscard]] std::optional<Stay> stay_at(float time_s) const;

  /// The waypoint of the current stay, or the last one before.
  [[nodiscard]] std::size_t last_stop(float time_s) const;

  [[nodiscard]] float period_s() const { return period_s_; }

 private:
  struct Leg {
    float begin_s = 0, end_s = 0;
    std::size_t stop = 0;  // its waypoint; for the path to the next one, the one before
    bool is_stay = false;
    std::vector<Eigen::Vector2f> path;  // closely spaced points; a single one: turning on the spot
    float length_m = 0;
    float turn_from_rad = 0, turn_to_rad = 0;
  };
  void add_turn(std::size_t stop, const Eigen::Vector2f& at_m, float to_rad);
  void add_walk(std::size_t stop, std::vector<Eigen::Vector2f> path, float pace_m_s);
  void add_stay(std::size_t number, const Waypoint& stop);
  void add_leg(Leg leg, float duration_s);
  [[nodiscard]] const Leg& leg_at(float time_s) const;
  [[nodiscard]] float wrapped(float time_s) const;

  std::vector<Leg> legs_;
  float period_s_ = 0;
  float heading_rad_ = 0;  // used during construction only
  bool rests_for_ever_ = false;
};

}  // namespace roomcast::simulator
