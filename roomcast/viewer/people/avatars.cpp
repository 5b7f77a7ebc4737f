// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/people/avatars.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace roomcast::viewer {
namespace {

constexpr double kEasing_per_s = 14;
constexpr double kArrived_m = 1e-4;
constexpr double kArrived_rad = 1e-3;

/// The ease functions return true while the value still changes.
bool ease(Eigen::Vector3d& shown_m, const Eigen::Vector3d& wanted_m, double share) {
  if ((wanted_m - shown_m).norm() < kArrived_m) return false;
  shown_m += share * (wanted_m - shown_m);
  return true;
}

bool ease(RigidTransform& shown, const RigidTransform& wanted, double share) {
  const Eigen::Quaterniond now(shown.rotation), then(wanted.rotation);
  const bool turns = now.angularDistance(then) >= kArrived_rad;
  if (turns) shown.rotation = now.slerp(share, then).normalized().toRotationMatrix();
  return ease(shown.translation_m, wanted.translation_m, share) || turns;
}

bool ease(client::PointerBeam& shown, const client::PointerBeam& wanted, double share) {
  const bool from_moves = ease(shown.from_m, wanted.from_m, share);
  return ease(shown.to_m, wanted.to_m, share) || from_moves;
}

/// A part that appears or disappears does so without easing.
template <class Part>
bool ease(std::optional<Part>& shown, const std::optional<Part>& wanted, double share) {
  if (shown && wanted) return ease(*shown, *wanted, share);
  const bool changes = shown.has_value() != wanted.has_value();
  shown = wanted;
  return changes;
}

bool ease(client::PersonPose& shown, const client::PersonPose& wanted, double share) {
  bool moves = ease(shown.world_from_head, wanted.world_from_head, share);
  moves |= ease(shown.world_from_left_hand, wanted.world_from_left_hand, share);
  moves |= ease(shown.world_from_right_hand, wanted.world_from_right_hand, share);
  moves |= ease(shown.pointer, wanted.pointer, share);
  return moves;
}

std::string name_of(const client::RoomPerson& person) {
  return person.name.empty() ? "viewer " + std::to_string(person.id.value) : person.name;
}

}  // namespace

void Avatars::follow(const client::RoomSnapshot& room) {
  std::vector<Avatar> people;
  std::vector<client::PersonPose> poses;
  for (const client::RoomPerson& person : room.people) {
    if (person.id == room.self || !person.pose) continue;
    const auto known = std::ranges::find(shown_, person.id, &Avatar::id);
    const client::PersonPose& shown = known != shown_.end() ? known->shown : *person.pose;
    people.push_back({person.id, name_of(person), person.color, shown});
    poses.push_back(*person.pose);
  }
  shown_ = std::move(people);
  wanted_ = std::move(poses);
}

bool Avatars::advance(double seconds) {
  const double share = 1 - std::exp(-kEasing_per_s * std::max(0.0, seconds));
  bool moves = false;
  for (std::size_t i = 0; i < shown_.size(); ++i) moves |= ease(shown_[i].shown, wanted_[i], share);
  return moves;
}

}  // namespace roomcast::viewer
