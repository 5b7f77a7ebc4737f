// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/sensing/interference.h"

#include <cmath>
#include <numbers>

#include "roomcast/simulator/random/value_noise.h"

namespace roomcast::simulator {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr float kRipple_mm = 8.0F;

std::int64_t second_of(nanoseconds time) {
  const std::int64_t whole = time.count() / kSecond;
  return time.count() % kSecond < 0 ? whole - 1 : whole;
}

nanoseconds seconds(float value) {
  return nanoseconds(static_cast<std::int64_t>(1e9 * static_cast<double>(value)));
}

}  // namespace

float InterferenceBurst::ripple_mm(int x, int y) const {
  const float turn = 2.0F * std::numbers::pi_v<float>;
  const float angle = turn * nth_unit(key, 10), length_px = 60.0F + 140.0F * nth_unit(key, 11);
  const float along =
      std::cos(angle) * static_cast<float>(x) + std::sin(angle) * static_cast<float>(y);
  return kRipple_mm * strength * std::sin(turn * along / length_px);
}

std::optional<InterferenceBurst> Interference::starting_in(std::int64_t second) const {
  const auto low = static_cast<std::uint32_t>(second);
  const std::uint32_t key = hash_of(key_, low);
  if (static_cast<double>(nth_unit(key, 1)) >= per_second_) return std::nullopt;
  InterferenceBurst burst;
  burst.begin = nanoseconds(second * kSecond) + seconds(nth_unit(key, 2));
  burst.end = burst.begin + seconds(0.2F + 0.5F * nth_unit(key, 3));
  burst.strength = 0.25F + 0.75F * nth_unit(key, 4);
  burst.key = key;
  return burst;
}

std::optional<InterferenceBurst> Interference::at(nanoseconds scene_time) const {
  for (std::int64_t second = second_of(scene_time), i = 0; i < 2; ++i, --second) {
    const auto burst = starting_in(second);
    if (burst && burst->begin <= scene_time && scene_time < burst->end) return burst;
  }
  return std::nullopt;
}

}  // namespace roomcast::simulator
