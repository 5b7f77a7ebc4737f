// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/clock_sync.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace roomcast::client {
namespace {

nanoseconds scaled(nanoseconds time, double factor) {
  return nanoseconds(static_cast<std::int64_t>(factor * static_cast<double>(time.count())));
}

template <class Time>
bool is_possible(Time time) {
  const nanoseconds shown = time.time_since_epoch();
  return -ClockSync::kFarthest <= shown && shown <= ClockSync::kFarthest;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void ClockSync::add(HostTime sent, RoomTime hub, HostTime received) {
  if (!is_possible(sent) || !is_possible(hub) || received < sent) return;
  const nanoseconds round_trip = received - sent;
  const HostTime middle = sent + round_trip / 2;
  const Exchange exchange{received, round_trip, hub.time_since_epoch() - middle.time_since_epoch()};
  if (window_.empty() || !contradicts_estimate(exchange)) return take(exchange);
  witnesses_.push_back(exchange);
  if (witnesses_.size() < kOutliersToReset) return;
  const auto witnesses = std::exchange(*this, {}).witnesses_;
  for (const Exchange& witness : witnesses) take(witness);
}

void ClockSync::take(const Exchange& exchange) {
  window_.push_back(exchange);
  if (window_.size() > kWindow) window_.pop_front();
  if (exchange.round_trip <= std::ranges::min(round_trips()) + kAgreement) witnesses_.clear();
  if (++since_remembered_ == kWindow) remember_quickest_of_window();
}

void ClockSync::remember_quickest_of_window() {
  since_remembered_ = 0;
  history_.push_back(*std::ranges::min_element(window_, {}, &Exchange::round_trip));
  if (history_.size() > kHistory) history_.pop_front();
  if (const auto measured = measured_drift()) drift_ = measured;
}

std::vector<nanoseconds> ClockSync::round_trips() const {
  std::vector<nanoseconds> all;
  for (const auto* exchanges : {&window_, &history_}) {
    for (const Exchange& exchange : *exchanges) all.push_back(exchange.round_trip);
  }
  return all;
}

std::optional<double> ClockSync::measured_drift() const {
  std::vector<Exchange> points;
  const nanoseconds longest = std::ranges::min(round_trips()) + kAgreement;
  std::ranges::copy_if(history_, std::back_inserter(points),
                       [&](const Exchange& exchange) { return exchange.round_trip <= longest; });
  if (points.size() < kFewestForDrift) return std::nullopt;
  std::vector<double> slopes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const nanoseconds apart = points[j].received - points[i].received;
      if (apart <= nanoseconds(0)) continue;
      const nanoseconds gained = points[j].room_minus_host - points[i].room_minus_host;
      slopes.push_back(static_cast<double>(gained.count()) / static_cast<double>(apart.count()));
    }
  }
  if (slopes.empty()) return std::nullopt;
  return std::clamp(median(std::move(slopes)), -kLargestDrift, kLargestDrift);
}

double ClockSync::drift_uncertainty() const {
  return drift_ ? kDriftUncertainty : kLargestDrift;
}

nanoseconds ClockSync::error_of(const Exchange& exchange, HostTime now) const {
  return (exchange.round_trip + nanoseconds(1)) / 2 +
         scaled(now - exchange.received, drift_uncertainty());
}

const ClockSync::Exchange& ClockSync::believed(HostTime now) const {
  const Exchange* best = &window_.front();
  for (const auto* exchanges : {&window_, &history_}) {
    for (const Exchange& exchange : *exchanges) {
      if (error_of(exchange, now) < error_of(*best, now)) best = &exchange;
    }
  }
  return *best;
}

ClockEstimate ClockSync::estimate_at(HostTime now) const {
  const Exchange& best = believed(now);
  const double drift = drift_.value_or(0);
  return {now, best.room_minus_host + scaled(now - best.received, drift), drift,
          error_of(best, now)};
}

// The round trip without waiting: the shortest one, if several are close to it. Else it is unknown,
// and 0 is assumed.
nanoseconds ClockSync::least_round_trip(const Exchange& newest) const {
  std::vector<nanoseconds> all = round_trips();
  all.push_back(newest.round_trip);
  if (all.size() < kOutliersToReset) return nanoseconds(0);
  std::ranges::partial_sort(all, all.begin() + kOutliersToReset);
  return all[kOutliersToReset - 1] <= all.front() + kAgreement ? all.front() : nanoseconds(0);
}

// The waiting of either exchange may have been in either direction; the network cannot explain a
// larger difference.
bool ClockSync::contradicts_estimate(const Exchange& exchange) const {
  const ClockEstimate expected = estimate_at(exchange.received);
  const nanoseconds difference =
      std::chrono::abs(exchange.room_minus_host - expected.room_minus_host);
  const nanoseconds waited = exchange.round_trip / 2 + expected.error - least_round_trip(exchange);
  return difference > waited + kAgreement;
}

std::optional<ClockEstimate> ClockSync::estimate() const {
  if (window_.empty()) return std::nullopt;
  return estimate_at(window_.back().received);
}

}  // namespace roomcast::client
