// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/performance.h"

#include <algorithm>
#include <cmath>

#include "roomcast/simulator/scene/angles.h"

namespace roomcast::simulator {
namespace {

using Eigen::AngleAxisf;
using Eigen::Isometry3f;
using Eigen::Quaternionf;
using Eigen::Vector3f;

constexpr float kGrasped = 0.35F, kLifted = 0.85F;  // shares of a kTakeUp or kPutDown stay

AngleAxisf pitched(float forward_rad) {
  return {forward_rad, Vector3f::UnitX()};
}
AngleAxisf yawed(float left_rad) {
  return {left_rad, Vector3f::UnitY()};
}

Isometry3f standing(const Vector3f& at_m, float heading_rad) {
  return Isometry3f(Eigen::Translation3f(at_m) * yawed(heading_rad));
}

Isometry3f between(const Isometry3f& a, const Isometry3f& b, float share) {
  Isometry3f mean = Isometry3f::Identity();
  mean.translation() = a.translation() + share * (b.translation() - a.translation());
  const Quaternionf turn = Quaternionf(Eigen::Matrix3f(a.linear()))
                               .slerp(share, Quaternionf(Eigen::Matrix3f(b.linear())));
  mean.linear() = turn.toRotationMatrix();
  return mean;
}

}  // namespace

struct Performance::Moment {
  double time_s;  // for motions that never repeat: swaying, talking
  float round_s;  // time within the round
  Itinerary::Place place;
  std::optional<Itinerary::Stay> stay;
  const Waypoint* stop;  // of the current stay, or the last one
  std::array<Footsteps::Foot, 2> feet;
  float walking;    // 0: not walking, 1: at full pace
  float phase_rad;  // of the gait
  Lean lean;
  float taken = 0;  // of the burden: 0 resting, 1 carried
  float held = 0;
  const Waypoint* rest = nullptr;  // waypoint at which the burden rests or rested last
  Quaternionf chest_in_pelvis;
  Isometry3f body, pelvis, chest, burden;
};

Performance::Performance(const Person& person)
    : measures_(measures_of(person.build)),
      stops_(person.stops),
      begin_s_(person.begin_s),
      itinerary_(person.stops, person.pace_m_s),
      footsteps_(itinerary_, measures_) {
  if (person.burden) {
    burden_.emplace();
    burden_->half_size_m = person.burden->half_size_m;
  }
}

float Performance::round_time(double time_s) const {
  const double period = itinerary_.period_s();
  const double rest = std::fmod(time_s + begin_s_, period);
  return static_cast<float>(rest < 0.0 ? rest + period : rest);
}

Performance::Instant Performance::at(double time_s) const {
  Moment now{};
  now.time_s = time_s;
  now.round_s = round_time(time_s);
  now.place = itinerary_.place_at(now.round_s);
  now.stay = itinerary_.stay_at(now.round_s);
  now.stop = &stops_[itinerary_.last_stop(now.round_s)];
  for (const Side side : kSides) now.feet[index_of(side)] = footsteps_.foot_at(now.round_s, side);
  now.walking = std::clamp(now.place.speed_m_s / 1.0F, 0.0F, 1.2F);
  now.phase_rad = 2.0F * kPi * footsteps_.phase_at(now.round_s);
  if (burden_) place_burden(now);
  now.lean = lean_at(now);
  place_trunk(now);
  bend_to_reach(now);
  PoseGoals goals;
  goals.pelvis = now.pelvis;
  goals.chest_in_pelvis = now.chest_in_pelvis;
  goals.head_in_chest = head_at(now);
  for (const Side side : kSides) {
    goals.feet[index_of(side)] = now.feet[index_of(side)].ankle;
    goals.hands[index_of(side)] = hand_at(now, side);
  }
  return {solve_pose(goals, measures_), now.burden, now.held};
}

void Performance::place_trunk(Moment& now) const {
  const float twist = -0.16F * now.walking * std::cos(now.phase_rad);
  const float breath = 0.012F * static_cast<float>(std::sin(1.7 * now.time_s));
  now.pelvis = pelvis_at(now);
  now.body = standing(now.pelvis.translation(), now.place.heading_rad);
  now.chest_in_pelvis =
      yawed(now.lean.chest_yaw - twist) *
      pitched(now.lean.chest_pitch + breath + 0.04F * now.walking - 0.10F * now.taken);
  now.chest = chest_on(now.pelvis, now.chest_in_pelvis, measures_);
  if (!burden_) return;
  const float ahead = 0.17F * measures_.girth + burden_->half_size_m.z() + 0.05F;
  const Isometry3f carried =
      now.body * Eigen::Translation3f(0, 0.20F * measures_.scale, ahead) * yawed(kPi);
  now.burden = between(resting(*now.rest), carried, now.taken);
}

/// Bends the trunk forward until both hands can reach their targets.
void Performance::bend_to_reach(Moment& now) const {
  constexpr int kSteps = 6;
  const float arm = 0.985F * (measures_.upper_arm + measures_.forearm);
  for (int i = 0; i < kSteps; ++i) {
    float lacking = 0.0F;
    for (const Side side : kSides) {
      const Vector3f way = hand_at(now, side).wrist_m - shoulder_of(now.chest, side, measures_);
      lacking = std::max(lacking, way.norm() - arm);
    }
    if (lacking <= 0.0F) return;
    now.lean.chest_pitch += 1.2F * lacking;
    now.lean.pelvis_pitch += 0.8F * lacking;
    place_trunk(now);
  }
}

Isometry3f Performance::resting(const Waypoint& stop) const {
  return standing(stop.target_m, stop.heading_rad + kPi);
}

void Performance::place_burden(Moment& now) const {
  const std::size_t count = stops_.size();
  const auto here = static_cast<std::size_t>(now.stop - stops_.data());
  const Waypoint* last = nullptr;  // that took or left it, including the current one
  for (std::size_t back = 0; back < count && last == nullptr; ++back) {
    const Waypoint& stop = stops_[(here + count - back) % count];
    if (stop.activity == Activity::kTakeUp || stop.activity == Activity::kPutDown) last = &stop;
  }
  if (last == nullptr) last = now.stop;
  now.rest = last;
  now.taken = now.held = last->activity == Activity::kTakeUp ? 1.0F : 0.0F;
  if (!now.stay || now.stop != last) return;
  const float share = now.stay->since_s / (now.stay->since_s + now.stay->left_s);
  if (last->activity == Activity::kTakeUp) {
    now.held = smooth_step(share / kGrasped);
    now.taken = smooth_step((share - kGrasped) / (kLifted - kGrasped));
  } else {
    now.held = 1.0F - smooth_step((share - 1.0F + kGrasped) / kGrasped);
    now.taken = 1.0F - smooth_step((share - 1.0F + kLifted) / (kLifted - kGrasped));
  }
}

Lean Performance::lean_at(const Moment& now) const {
  const bool handles =
      now.stop->activity == Activity::kTakeUp || now.stop->activity == Activity::kPutDown;
  if (burden_ && handles && now.stay) return lean_towards(*now.stop, now.held * (1.0F - now.taken));
  return now.stay ? lean_of(*now.stop, *now.stay, now.time_s) : Lean{};
}

Isometry3f Performance::pelvis_at(const Moment& now) const {
  const Lean& lean = now.lean;
  const float still = 1.0F - std::min(1.0F, now.walking);
  const auto wave = [&](double per_second) {
    return static_cast<float>(std::sin(per_second * now.time_s));
  };
  const float sway = 0.007F * still * (wave(0.71) + 0.5F * wave(1.13)) -
                     0.018F * now.walking * std::sin(now.phase_rad + 0.5F);
  const Vector3f ahead(std::sin(now.place.heading_rad), 0, std::cos(now.place.heading_rad));
  const Vector3f left(ahead.z(), 0, -ahead.x());
  const float bob = -0.012F * now.walking * std::cos(2.0F * now.phase_rad + 0.6F);
  const float height = measures_.hips_standing() - 0.012F - 0.02F * now.walking + bob - lean.sink_m;
  Vector3f at = Vector3f(now.place.at_m.x(), height, now.place.at_m.y()) +
                (0.5F * sway - lean.hips_back_m) * ahead + sway * left;
  const Vector3f seat = now.stop->seat_m + Vector3f(0, 0.098F * measures_.scale, 0);
  at += lean.seated * (seat - at);

  const float yaw = now.place.heading_rad - 0.09F * now.walking * std::cos(now.phase_rad);
  Isometry3f pelvis(Eigen::Translation3f(at) * yawed(yaw) * pitched(lean.pelvis_pitch));
  // Lowers the hips until both feet are within reach of the legs.
  const float reach = 0.998F * measures_.leg();
  float too_high = 0.0F;
  for (const Side side : kSides) {
    const Vector3f way =
        hip_of(pelvis, side, measures_) - now.feet[index_of(side)].ankle.translation();
    const float across = std::hypot(way.x(), way.z());
    const float most = std::sqrt(std::max(0.01F, reach * reach - across * across));
    too_high = std::max(too_high, way.y() - most);
  }
  pelvis.translation().y() -= too_high;
  return pelvis;
}

Quaternionf Performance::head_at(const Moment& now) const {
  const auto wave = [&](double per_second, double shift) {
    return static_cast<float>(std::sin(per_second * now.time_s + shift));
  };
  const float idle_yaw = 0.22F * wave(0.37, 0.0) + 0.10F * wave(0.83, 1.0);
  const float upright = -0.75F * (now.lean.chest_pitch + now.lean.pelvis_pitch);
  const Vector3f eyes = now.chest * Vector3f(0, measures_.neck + 0.1F, 0.05F);
  const Vector3f way = now.chest.linear().transpose() * (now.stop->target_m - eyes);
  const float to_yaw = std::clamp(std::atan2(way.x(), way.z()), -1.0F, 1.0F);
  const float to_pitch =
      std::clamp(-std::atan2(way.y(), std::hypot(way.x(), way.z())), -0.5F, 0.7F);
  const float looks = now.lean.looks;
  const float yaw = (1.0F - looks) * idle_yaw + looks * (to_yaw + 0.15F * idle_yaw);
  const float pitch = (1.0F - looks) * (upright + 0.04F * wave(0.53, 2.0)) + looks * to_pitch;
  return yawed(yaw) * pitched(pitch);
}

HandGoal Performance::hanging(const Moment& now, Side side) const {
  const float side_sign = sign_of(side);
  // In the first half of the gait cycle the left foot moves forward and the left arm backward.
  const float swing = side_sign * 0.40F * now.walking * std::cos(now.phase_rad) * 0.9F;
  const float bend = 0.22F + 0.30F * std::max(0.0F, swing) + 0.12F * now.walking;
  const Isometry3f upright =
      standing(shoulder_of(now.chest, side, measures_), now.place.heading_rad + now.lean.chest_yaw);
  const auto arm_way = [&](float ahead_rad, float out_rad) {
    return Vector3f(side_sign * std::sin(out_rad), -std::cos(out_rad) * std::cos(ahead_rad),
                    std::sin(ahead_rad));
  };
  const float out = 0.13F + 0.10F * (measures_.girth - 1.0F);
  const Vector3f wrist = measures_.upper_arm * arm_way(swing - 0.06F, out) +
                         measures_.forearm * arm_way(swing + bend, 0.2F * out);
  HandGoal goal;
  goal.wrist_m = upright * wrist;
  goal.elbow_way = upright.linear() * Vector3f(0.35F * side_sign, 0, -1);
  return goal;
}

Vector3f Performance::grip(const Burden& burden, Side side) {
  // The burden's front faces its carrier, so the left hand is at its -x side.
  return {-sign_of(side) * burden.half_size_m.x(), -0.25F * burden.half_size_m.y(),
          0.2F * burden.half_size_m.z()};
}

HandGoal Performance::hand_at(const Moment& now, Side side) const {
  HandGoal goal = hanging(now, side);
  HandTarget target;
  if (burden_ && now.held > 0.0F) {
    target = {now.burden * grip(*burden_, side), palms_inward(now.body, 0.15F), now.held};
  } else if (now.stay) {
    target = hand_target(*now.stop, *now.stay, side, now.time_s, now.body, measures_);
  }
  if (target.share <= 0.0F) return goal;
  const Vector3f wrist = target.palm_m - target.turned * palm_in_hand(side, measures_);
  goal.wrist_m += target.share * (wrist - goal.wrist_m);
  const Vector3f elbow = now.body.linear() * Vector3f(0.55F * sign_of(side), -0.7F, -0.5F);
  goal.elbow_way += target.share * (elbow - goal.elbow_way);
  goal.turned = target.turned;
  goal.turned_share = target.share;
  return goal;
}

}  // namespace roomcast::simulator
