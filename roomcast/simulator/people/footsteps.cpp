// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/footsteps.h"

#include <algorithm>
#include <cmath>

#include "roomcast/simulator/scene/angles.h"

namespace roomcast::simulator {
namespace {

using Eigen::AngleAxisf;
using Eigen::Isometry3f;
using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kBeat_s = 0.54F;
constexpr float kSwing = 0.78F;                       // share of a beat, foot in the air
constexpr float kMidStance = 0.5F * (2.0F + kSwing);  // in beats after being lifted
constexpr float kFlat_s = 0.10F;                      // from heel contact to the whole sole
constexpr float kHeelOff_s = 0.22F;                   // time before being lifted
constexpr float kPushOff_rad = 0.62F, kHeelFirst_rad = -0.26F;
constexpr float kLift_m = 0.055F;
constexpr float kNear_m = 0.03F, kNear_rad = 0.12F;

}  // namespace

Footsteps::Footsteps(const Itinerary& itinerary, const Measures& measures)
    : measures_(measures), period_s_(itinerary.period_s()) {
  const int pairs = std::max(1, static_cast<int>(std::lround(period_s_ / (2.0F * kBeat_s))));
  steps_.resize(2U * static_cast<std::size_t>(pairs));
  beat_s_ = period_s_ / static_cast<float>(steps_.size());
  std::array<Placement, 2> stands = {wanted(itinerary, 0, Side::kLeft),
                                     wanted(itinerary, 0, Side::kRight)};
  for (int round = 0; round < 2; ++round) {  // the second round makes it periodic
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const Side side = kSides[i % 2];
      const float middle = (static_cast<float>(i) + kMidStance) * beat_s_;
      const Placement to = wanted(itinerary, middle, side);
      Placement& stand = stands[i % 2];
      const bool lifted = (to.at_m - stand.at_m).norm() > kNear_m ||
                          std::abs(angle_between(stand.heading_rad, to.heading_rad)) > kNear_rad;
      steps_[i] = {stand, lifted ? to : stand, lifted};
      stand = steps_[i].to;
    }
  }
}

Footsteps::Placement Footsteps::wanted(const Itinerary& itinerary, float time_s, Side side) const {
  const Itinerary::Place place = itinerary.place_at(time_s);
  const Vector2f left(std::cos(place.heading_rad), -std::sin(place.heading_rad));
  const float apart = place.speed_m_s > 0.4F ? 0.065F : 0.095F;
  return {place.at_m + sign_of(side) * apart * measures_.scale * left,
          place.heading_rad + sign_of(side) * 0.10F};
}

float Footsteps::since_slot(float time_s, std::size_t slot) const {
  const float since = std::fmod(time_s - static_cast<float>(slot) * beat_s_, period_s_);
  return since < 0.0F ? since + period_s_ : since;
}

std::size_t Footsteps::last_slot(float time_s, Side side) const {
  float wrapped = std::fmod(time_s, period_s_);
  if (wrapped < 0.0F) wrapped += period_s_;
  const auto count = steps_.size();
  const auto slot = std::min(static_cast<std::size_t>(wrapped / beat_s_), count - 1);
  return slot % 2 == index_of(side) ? slot : (slot + count - 1) % count;
}

Isometry3f Footsteps::rolled(const Placement& at, float lift_m, float roll_rad) const {
  const float s = measures_.scale;
  const Vector3f pivot = roll_rad > 0.0F ? Vector3f(0, -measures_.ankle, 0.125F * s)
                                         : Vector3f(0, -measures_.ankle, -0.055F * s);
  return Isometry3f(Eigen::Translation3f(at.at_m.x(), measures_.ankle + lift_m, at.at_m.y()) *
                    AngleAxisf(at.heading_rad, Vector3f::UnitY()) * Eigen::Translation3f(pivot) *
                    AngleAxisf(roll_rad, Vector3f::UnitX()) * Eigen::Translation3f(-pivot));
}

Footsteps::Foot Footsteps::foot_at(float time_s, Side side) const {
  const std::size_t slot = last_slot(time_s, side);
  const Step& step = steps_[slot];
  const Step& next = steps_[(slot + 2) % steps_.size()];
  const float since = since_slot(time_s, slot);
  const float swing_s = kSwing * beat_s_;
  const auto eagerness = [](const Step& s) {  // short steps roll less
    return std::clamp((s.to.at_m - s.from.at_m).norm() / 0.5F, 0.0F, 1.0F);
  };
  if (step.lifted && since < swing_s) {
    const float share = since / swing_s;
    const float moved = smooth_step(share);
    const float turn = angle_between(step.from.heading_rad, step.to.heading_rad);
    const Placement between{step.from.at_m + moved * (step.to.at_m - step.from.at_m),
                            step.from.heading_rad + moved * turn};
    const float lift = kLift_m * (0.5F + 0.5F * eagerness(step)) * std::sin(kPi * share);
    const float roll = eagerness(step) * (kPushOff_rad * (1.0F - smooth_step(share / 0.55F)) +
                                          kHeelFirst_rad * smooth_step((share - 0.45F) / 0.5F));
    return {rolled(between, lift, roll), false, Vector3f::Zero()};
  }
  float roll = 0.0F;
  if (step.lifted && since < swing_s + kFlat_s)
    roll = kHeelFirst_rad * eagerness(step) * (1.0F - smooth_step((since - swing_s) / kFlat_s));
  const float to_lift = 2.0F * beat_s_ - since;
  if (next.lifted && to_lift < kHeelOff_s)
    roll = kPushOff_rad * eagerness(next) * smooth_step(1.0F - to_lift / kHeelOff_s);
  const float pivot_z = (roll > 0.0F ? 0.125F : -0.055F) * measures_.scale;
  return {rolled(step.to, 0.0F, roll), true, {0, -measures_.ankle, pivot_z}};
}

float Footsteps::phase_at(float time_s) const {
  return std::fmod(time_s, 2.0F * beat_s_) / (2.0F * beat_s_);
}

}  // namespace roomcast::simulator
