// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/routes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kShoulders_m = 0.34F;  // half the width of a path
constexpr float kArm_m = 0.52F;        // from between the feet to the target of a hand

float heading_to(const Vector2f& from_m, const Vector2f& to_m) {
  return std::atan2(to_m.x() - from_m.x(), to_m.y() - from_m.y());
}

}  // namespace

Route::Route(Room& room, FloorPlan& plan, Random& random)
    : room_(room), plan_(plan), random_(random) {
  plaza_m_ = {random.between(-0.06F, 0.06F) * room.size_m.x(),
              random.between(-0.06F, 0.06F) * room.size_m.z()};
  const Vector2f beside(0.25F, 0.0F);
  plan.keep_way(plaza_m_ - beside, plaza_m_ + beside, 0.5F);
}

bool Route::way_is_free(const Vector2f& to_m) const {
  const Vector2f way = plaza_m_ - to_m;
  Footprint strip;
  const Vector2f from = to_m + std::min(0.3F, way.norm()) * way.normalized();
  strip.centre_m = 0.5F * (from + plaza_m_);
  strip.half_m = {kShoulders_m - 0.06F, 0.5F * (plaza_m_ - from).norm()};
  strip.yaw_rad = std::atan2(way.x(), way.y());
  return std::none_of(plan_.taken().begin(), plan_.taken().end(),
                      [&](const Footprint& other) { return overlap(strip, other, 0.0F); });
}

bool Route::to_sit(const Seat& seat) {
  if (!way_is_free(seat.stand_m)) return false;
  plan_.keep_way(seat.stand_m, plaza_m_, kShoulders_m);
  Waypoint stop;
  stop.at_m = seat.stand_m;
  stop.heading_rad = seat.heading_rad;
  stop.seat_m = seat.seat_m;
  stop.activity = Activity::kSit;
  stop.stay_s = random_.between(6.0F, 9.0F);
  stops_.push_back(stop);
  return true;
}

bool Route::to_reach(const Eigen::Affine3f& piece, const Vector3f& point_m, Activity activity,
                     float stay_s) {
  Waypoint stop;
  stop.target_m = piece * point_m;
  const Vector3f front = piece.linear().col(2);
  const Vector2f out(front.x(), front.z());
  // The right hand works slightly to the right of the centre.
  const Vector2f left(-out.y(), out.x());
  const bool one_handed = activity != Activity::kTakeUp && activity != Activity::kPutDown;
  stop.at_m = Vector2f(stop.target_m.x(), stop.target_m.z()) + kArm_m * out -
              (one_handed ? 0.14F : 0.0F) * left;
  stop.heading_rad = std::atan2(-out.x(), -out.y());
  stop.activity = activity;
  stop.stay_s = stay_s;
  if (!way_is_free(stop.at_m)) return false;
  plan_.keep_way(stop.at_m, plaza_m_, kShoulders_m);
  stops_.push_back(stop);
  return true;
}

void Route::then(Activity activity, float stay_s) {
  Waypoint stop = stops_.back();
  stop.activity = activity;
  stop.stay_s = stay_s;
  stops_.push_back(stop);
}

Person Route::walker() {
  Person person = draw_person(room_, random_);
  for (std::size_t i = 0; i < stops_.size(); ++i) {
    Waypoint stop = stops_[i];
    const Waypoint& before = stops_[(i + stops_.size() - 1) % stops_.size()];
    const bool same_place = (stop.at_m - before.at_m).norm() < 0.1F;
    const bool carrying = before.activity == Activity::kTakeUp;
    if (!same_place && (carrying || i > 0)) {
      stop.via_m = {plaza_m_};
    } else if (!same_place) {
      Waypoint pause;
      pause.at_m = plaza_m_;
      pause.heading_rad = heading_to(before.at_m, plaza_m_);
      pause.stay_s = random_.between(1.5F, 3.0F);
      person.stops.push_back(pause);
    }
    person.stops.push_back(stop);
  }
  stops_.clear();
  person.pace_m_s = random_.between(0.9F, 1.15F);
  return person;
}

std::optional<Person> Route::bystander() {
  const auto at = plan_.in_the_open({0.60F, 1.2F, 0.60F});
  if (!at) return std::nullopt;
  Person person = draw_person(room_, random_);
  Waypoint stop;
  stop.at_m = {at->translation().x(), at->translation().z()};
  stop.heading_rad = heading_to(stop.at_m, plaza_m_ + Vector2f(0.01F, 0));
  stop.activity = random_.chance(0.5F) ? Activity::kTalk : Activity::kStand;
  stop.stay_s = 20.0F;
  stop.target_m = {plaza_m_.x(), 1.5F, plaza_m_.y()};
  person.stops = {stop};
  person.begin_s = random_.between(0.0F, 10.0F);
  return person;
}

Waypoint typing_at(const Eigen::Affine3f& desk) {
  Waypoint stop;
  const Vector3f front = desk.linear().col(2);
  const Vector3f feet = desk * Vector3f(-0.12F, 0, 0.09F);
  stop.at_m = {feet.x(), feet.z()};
  stop.heading_rad = std::atan2(-front.x(), -front.z());
  stop.seat_m = desk * Vector3f(-0.12F, 0.50F, 0.50F);
  stop.target_m = desk * Vector3f(-0.12F, 0.785F, 0.19F);
  stop.activity = Activity::kType;
  stop.stay_s = 30.0F;
  return stop;
}

}  // namespace roomcast::simulator
