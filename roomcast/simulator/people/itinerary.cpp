// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/itinerary.h"

#include <algorithm>
#include <cmath>

#include "roomcast/core/assert.h"
#include "roomcast/simulator/scene/angles.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector2f;

constexpr float kTurn_rad_s = 1.5F;
constexpr float kRamp_s = 0.7F;  // acceleration to full pace, and deceleration
constexpr float kForEver_s = 1e6F;

float heading_of(const Vector2f& way) {
  return std::atan2(way.x(), way.y());
}

/// A smooth curve through the points (Catmull & Rom 1974), sampled every few centimetres.
std::vector<Vector2f> curve_through(const std::vector<Vector2f>& points) {
  constexpr float kSpacing_m = 0.03F;
  std::vector<Vector2f> curve = {points.front()};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vector2f& b = points[i];
    const Vector2f& c = points[i + 1];
    const Vector2f a = i > 0 ? points[i - 1] : Vector2f(2.0F * b - c);
    const Vector2f d = i + 2 < points.size() ? points[i + 2] : Vector2f(2.0F * c - b);
    const int steps = std::max(1, static_cast<int>(std::ceil((c - b).norm() / kSpacing_m)));
    for (int k = 1; k <= steps; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(steps);
      curve.push_back(0.5F *
                      (2.0F * b + t * (c - a) + t * t * (2.0F * a - 5.0F * b + 4.0F * c - d) +
                       t * t * t * (3.0F * b - a - 3.0F * c + d)));
    }
  }
  return curve;
}

float length_of(const std::vector<Vector2f>& path) {
  float length = 0;
  for (std::size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

/// Share of a path covered after a share of its time: ramps at both ends, constant pace between.
struct Progress {
  float done, rate;  // rate: derivative with respect to the share of the time
};
Progress ramped(float share, float ramp_share) {
  const float full = 1.0F / (1.0F - ramp_share);
  if (share < ramp_share)
    return {0.5F * full * share * share / ramp_share, full * share / ramp_share};
  if (share > 1.0F - ramp_share) {
    const float left = 1.0F - share;
    return {1.0F - 0.5F * full * left * left / ramp_share, full * left / ramp_share};
  }
  return {full * (share - 0.5F * ramp_share), full};
}

/// Point and heading at a share of the length of a path with nearly equidistant points.
Itinerary::Place along(const std::vector<Vector2f>& path, float share) {
  constexpr float kLook = 4.0F;  // points; the heading is taken over this span to smooth corners
  const auto last = static_cast<float>(path.size() - 1);
  const auto point = [&](float index) -> Vector2f {
    const float at = std::clamp(index, 0.0F, last);
    const auto below = std::min(static_cast<std::size_t>(at), path.size() - 2);
    const float rest = at - static_cast<float>(below);
    return path[below] + rest * (path[below + 1] - path[below]);
  };
  const float index = share * last;
  return {point(index), heading_of(point(index + kLook) - point(index - kLook)), 0.0F};
}

}  // namespace

Itinerary::Itinerary(std::span<const Waypoint> stops, float pace_m_s) {
  ROOMCAST_ASSERT(!stops.empty());
  heading_rad_ = stops.front().heading_rad;
  rests_for_ever_ = stops.size() == 1;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    add_stay(i, stops[i]);
    if (rests_for_ever_) break;
    const Waypoint& next = stops[(i + 1) % stops.size()];
    std::vector<Vector2f> points = {stops[i].at_m};
    points.insert(points.end(), next.via_m.begin(), next.via_m.end());
    points.push_back(next.at_m);
    auto path = curve_through(points);
    if (length_of(path) > 0.05F) {
      add_turn(i, stops[i].at_m, along(path, 0.0F).heading_rad);
      add_walk(i, std::move(path), pace_m_s);
    }
    add_turn(i, next.at_m, next.heading_rad);
  }
}

void Itinerary::add_leg(Leg leg, float duration_s) {
  leg.begin_s = period_s_;
  period_s_ += duration_s;
  leg.end_s = period_s_;
  legs_.push_back(std::move(leg));
}

void Itinerary::add_turn(std::size_t stop, const Vector2f& at_m, float to_rad) {
  const float by = angle_between(heading_rad_, to_rad);
  if (std::abs(by) < 0.02F) return;
  Leg leg;
  leg.stop = stop;
  leg.path = {at_m};
  leg.turn_from_rad = heading_rad_;
  leg.turn_to_rad = heading_rad_ + by;
  heading_rad_ = to_rad;
  add_leg(std::move(leg), 0.3F + 1.2F * std::abs(by) / kTurn_rad_s);
}

void Itinerary::add_walk(std::size_t stop, std::vector<Vector2f> path, float pace_m_s) {
  Leg leg;
  leg.stop = stop;
  leg.length_m = length_of(path);
  leg.path = std::move(path);
  heading_rad_ = along(leg.path, 1.0F).heading_rad;
  const float duration = leg.length_m / pace_m_s + kRamp_s;
  add_leg(std::move(leg), duration);
}

void Itinerary::add_stay(std::size_t number, const Waypoint& stop) {
  Leg leg;
  leg.stop = number;
  leg.is_stay = true;
  leg.path = {stop.at_m};
  leg.turn_from_rad = leg.turn_to_rad = stop.heading_rad;
  add_leg(std::move(leg), std::max(0.05F, stop.stay_s));
}

float Itinerary::wrapped(float time_s) const {
  const float rest = std::fmod(time_s, period_s_);
  return rest < 0.0F ? rest + period_s_ : rest;
}

const Itinerary::Leg& Itinerary::leg_at(float time_s) const {
  const float time = wrapped(time_s);
  const auto leg = std::find_if(legs_.begin(), legs_.end(),
                                [&](const Leg& candidate) { return time < candidate.end_s; });
  return leg == legs_.end() ? legs_.back() : *leg;
}

Itinerary::Place Itinerary::place_at(float time_s) const {
  const Leg& leg = leg_at(time_s);
  const float duration = leg.end_s - leg.begin_s;
  const float share = (wrapped(time_s) - leg.begin_s) / duration;
  if (leg.path.size() == 1) {
    const float by = leg.turn_to_rad - leg.turn_from_rad;
    return {leg.path.front(), leg.turn_from_rad + smooth_step(share) * by, 0.0F};
  }
  const Progress progress = ramped(share, std::min(0.5F, kRamp_s / duration));
  Place place = along(leg.path, progress.done);
  place.speed_m_s = progress.rate * leg.length_m / duration;
  return place;
}

std::optional<Itinerary::Stay> Itinerary::stay_at(float time_s) const {
  const Leg& leg = leg_at(time_s);
  if (!leg.is_stay) return std::nullopt;
  if (rests_for_ever_) return Stay{leg.stop, kForEver_s, kForEver_s};
  const float time = wrapped(time_s);
  return Stay{leg.stop, time - leg.begin_s, leg.end_s - time};
}

std::size_t Itinerary::last_stop(float time_s) const {
  return leg_at(time_s).stop;
}

}  // namespace roomcast::simulator
