// SPDX-License-Identifier: Apache-2.0
#include "bench/model/color_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace roomcast::bench {
namespace {

constexpr float kCube_m = 0.5F;
constexpr std::size_t kMinPlaces = 200;

bool is_judged(const Eigen::Vector3f& at_m) {
  const Eigen::Vector3i cube = (at_m / kCube_m).array().floor().cast<int>();
  return (cube.sum() & 1) != 0;
}

using Differences = std::array<std::vector<float>, 3>;

double step_of(Differences& differences) {
  double sum = 0;
  for (std::vector<float>& channel : differences) {
    const auto middle = channel.begin() + static_cast<std::ptrdiff_t>(channel.size() / 2);
    std::ranges::nth_element(channel, middle);
    sum += std::abs(static_cast<double>(*middle));
  }
  return sum / 3;
}

/// Also the number of pairs.
std::pair<ColorStep, std::size_t> steps(const std::vector<model::SharedColor>& places,
                                        std::span<const Eigen::Vector3f> gains) {
  std::map<std::pair<std::size_t, std::size_t>, Differences> of_pair;
  for (const model::SharedColor& place : places) {
    const Eigen::Vector3f difference = place.color_a.cwiseProduct(gains[place.view_a]) -
                                       place.color_b.cwiseProduct(gains[place.view_b]);
    for (int c = 0; c < 3; ++c)
      of_pair[{place.view_a, place.view_b}][static_cast<std::size_t>(c)].push_back(difference[c]);
  }
  ColorStep step;
  std::size_t pairs = 0;
  for (auto& [pair, differences] : of_pair) {
    if (differences[0].size() < kMinPlaces) continue;
    const double of_this = step_of(differences);
    step.mean += of_this;
    step.largest = std::max(step.largest, of_this);
    ++pairs;
  }
  if (pairs > 0) step.mean /= static_cast<double>(pairs);
  return {step, pairs};
}

}  // namespace

ColorSteps color_steps(std::span<const model::SharedColor> shared, std::size_t view_count) {
  std::vector<model::SharedColor> judged, known;
  for (const model::SharedColor& place : shared)
    (is_judged(place.at_m) ? judged : known).push_back(place);
  const std::vector<Eigen::Vector3f> none(view_count, Eigen::Vector3f::Ones());
  const auto gains = model::color_gains(known, view_count);
  const auto [before, pairs] = steps(judged, none);
  return {pairs, before, steps(judged, gains).first};
}

}  // namespace roomcast::bench
