// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/walkabout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;

constexpr float kSamePlace_m = 0.4F;
constexpr float kPause_s = 0.6F;     // at every turn
constexpr float kTurned_rad = 1.9F;  // angle between turns

bool goes_somewhere(const Person& person) {
  return std::ranges::any_of(person.stops, [&](const Waypoint& stop) {
    return !is_same_place(stop.at_m, person.stops.front().at_m);
  });
}

}  // namespace

bool is_same_place(const Vector2f& a_m, const Vector2f& b_m) {
  return (a_m - b_m).norm() < kSamePlace_m;
}

const Person* whoever_walks(const Room& room) {
  const auto walker = std::ranges::find_if(room.people, goes_somewhere);
  return walker == room.people.end() ? nullptr : &*walker;
}

Waypoint standing_at(const Vector2f& at_m, float heading_rad, float stay_s) {
  Waypoint stop;
  stop.at_m = at_m;
  stop.heading_rad = heading_rad;
  stop.stay_s = stay_s;
  stop.target_m = {at_m.x() + std::sin(heading_rad), 1.4F, at_m.y() + std::cos(heading_rad)};
  return stop;
}

bool add_walkabout(Room& room) {
  const Person* const walker = whoever_walks(room);
  if (walker == nullptr) return false;
  Person person = *walker;
  std::vector<Waypoint> stops;
  float heading_rad = 0;
  for (const Waypoint& stop : person.stops) {
    if (!stops.empty() && is_same_place(stops.back().at_m, stop.at_m)) continue;
    stops.push_back(standing_at(stop.at_m, heading_rad += kTurned_rad, kPause_s));
    stops.back().via_m = stop.via_m;
    stops.push_back(standing_at(stop.at_m, heading_rad += kTurned_rad, kPause_s));
  }
  person.stops = std::move(stops);
  person.begin_s = 0;
  person.burden.reset();
  room.people = {std::move(person)};
  return true;
}

}  // namespace roomcast::simulator
