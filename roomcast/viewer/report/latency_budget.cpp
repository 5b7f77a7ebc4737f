// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/report/latency_budget.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace roomcast::viewer {
namespace {

double in_ms(nanoseconds time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

void LatencyBudget::shown(const client::SensorPicture& picture,
                          const std::optional<client::ClockEstimate>& clock, HostTime begin,
                          HostTime end) {
  LatencyStages stages;
  stages.decoding_ms = in_ms(picture.decoded - picture.received);
  stages.waiting_ms = in_ms(begin - picture.decoded);
  stages.drawing_ms = in_ms(end - begin);
  if (clock) {
    stages.to_here_ms = in_ms(clock->room_time(picture.received) - picture.capture_time);
    stages.total_ms = in_ms(clock->room_time(end) - picture.capture_time);
    stages.clock_error_ms = in_ms(clock->error);
  }
  passages_.push_back({end, stages});
  while (end - passages_.front().at > kWindow) passages_.pop_front();
}

std::optional<LatencyStages> LatencyBudget::median(HostTime now) const {
  const auto of = [&](auto stage) {
    std::vector<double> values;
    for (const Passage& passage : passages_) {
      if (now - passage.at > kWindow) continue;
      const std::optional<double> value = std::invoke(stage, passage.stages);
      if (value) values.push_back(*value);
    }
    return median_of(std::move(values));
  };
  const auto decoding_ms = of(&LatencyStages::decoding_ms);
  if (!decoding_ms) return std::nullopt;
  return LatencyStages{of(&LatencyStages::to_here_ms),  *decoding_ms,
                       *of(&LatencyStages::waiting_ms), *of(&LatencyStages::drawing_ms),
                       of(&LatencyStages::total_ms),    of(&LatencyStages::clock_error_ms)};
}

}  // namespace roomcast::viewer
