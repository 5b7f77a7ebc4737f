// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/board_bearer.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "roomcast/simulator/scene/walkabout.h"

namespace roomcast::simulator {
namespace {

using Eigen::Affine3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kStill_s = 1.4F;                 // pause after each turn
constexpr int kTurns = 10;                       // per place
constexpr float kTurned_rad = 0.63F;             // angle between turns
constexpr float kArm_m = 0.45F, kRest_m = 0.9F;  // initial place of the board: ahead, height
constexpr float kAboveHands_m = 0.17F;           // centre of the panel
constexpr float kPictureSide_m = kBoardTagSide_m * 10 / 8;  // with a white cell around

/// An A3 panel with its back towards the carrier, held by its lower corners: a hand on a corner of
/// the tag would hide it from one side.
Burden board(Room& room) {
  Burden burden;
  burden.half_size_m = {0.1485F, 0.21F, 0.008F};
  TriangleMesh& mesh = burden.mesh;
  const SurfaceIndex white = room.add(painted(Pattern::kPlain, 0xf2f2f0, 0xf2f2f0, 0, 0, 0.6F));
  Surface tag = painted(Pattern::kTag, 0xf4f4f4, 0x101010, 0, kBoardTag, 0.5F);
  tag.size_m = Vector2f::Constant(kPictureSide_m);
  const SurfaceIndex printed = room.add(tag);
  const Affine3f raised(Eigen::Translation3f(0, kAboveHands_m, 0));
  add_box(mesh, white, raised, -burden.half_size_m, burden.half_size_m);
  const float half = 0.5F * kPictureSide_m;
  const float front = -burden.half_size_m.z() - 0.001F;
  add_quad(mesh, printed, raised, {half, -half, front}, {-kPictureSide_m, 0, 0},
           {0, kPictureSide_m, 0});
  return burden;
}

/// The places at which a person stops without touching anything, each once.
std::vector<Vector2f> places_of(const Person& person) {
  std::vector<Vector2f> places;
  const auto add = [&](const Vector2f& at) {
    const auto is_here = [&](const Vector2f& known) { return is_same_place(known, at); };
    if (std::ranges::none_of(places, is_here)) places.push_back(at);
  };
  for (const Waypoint& stop : person.stops) {
    for (const Vector2f& via : stop.via_m) add(via);
    add(stop.at_m);
  }
  return places;
}

Waypoint handling(const Waypoint& place, Activity activity) {
  Waypoint stop = place;
  stop.activity = activity;
  stop.target_m = {place.at_m.x() + kArm_m * std::sin(place.heading_rad), kRest_m,
                   place.at_m.y() + kArm_m * std::cos(place.heading_rad)};
  return stop;
}

}  // namespace

bool add_board_bearer(Room& room) {
  const Person* const walker = whoever_walks(room);
  if (walker == nullptr) return false;
  Person person = *walker;
  std::vector<Waypoint> stops;
  float heading_rad = 0;
  for (const Vector2f& at : places_of(person)) {
    for (int turn = 0; turn < kTurns; ++turn)
      stops.push_back(standing_at(at, heading_rad += kTurned_rad, kStill_s));
  }
  stops.insert(stops.begin(), handling(stops.front(), Activity::kTakeUp));
  stops.push_back(handling(stops.front(), Activity::kPutDown));
  person.stops = std::move(stops);
  person.begin_s = 0;
  person.burden = board(room);
  room.people = {std::move(person)};
  return true;
}

}  // namespace roomcast::simulator
