// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/uplink/bandwidth_estimator.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace roomcast::client {
namespace {

using namespace std::chrono_literals;

constexpr auto kMemory = 2s;
constexpr auto kMaxGap = 500ms;  // between readings; a longer one is a program that did not run

// When a full line is too slow. A short look is coarse: it must show much less than the rate.
constexpr auto kShortLook = 120ms, kLongLook = 300ms;
constexpr double kMuchLess = 0.65, kLess = 0.97;
constexpr double kRoundTripsOfLook = 4;
constexpr double kMinBytesOfLook = 8 * 1448;  // fewer segments arrive too unevenly
constexpr auto kInterruption = 100ms;         // in which nothing arrives although bytes wait

constexpr double kCut = 0.86;    // of what was delivered: what waits leaves meanwhile
constexpr double kMaxCut = 0.3;  // of the rate before, at once
constexpr auto kCutInterval = 150ms;

// Losses take a part of what a line delivers, so where packets were lost the best part of the look
// counts.
constexpr auto kPartOfLook = 80ms;

// Growth, per second, as a logarithm.
const double kStartGrowth = std::log(4.0), kReturnGrowth = std::log(2.0),
             kMaxGrowth = std::log(4.0);
constexpr double kCarefulGrowth = 0.1;
constexpr double kNear = 0.85, kBeyond = 1.04;  // of the last capacity
constexpr double kGrowthDoubles_s = 0.25;
constexpr double kFairGrowth = 12'000;  // bytes/s each second
constexpr double kBelowBbr = 0.95;

constexpr auto kUseLook = 1s;
constexpr double kUsed = 0.6;    // of the rate; a rate that is not used is not proved
constexpr double kAgeing = 0.1;  // per second, of a rate that is not used
constexpr auto kQueue = 25ms;    // of round trip above the least
constexpr double kQueueShare = 0.25;
constexpr double kRoundTripAgeing = 0.01;  // per second: the way may have become longer

double seconds_of(nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}
nanoseconds times(double factor, nanoseconds time) {
  return nanoseconds(static_cast<std::int64_t>(factor * static_cast<double>(time.count())));
}

}  // namespace

void BandwidthEstimator::add(const Reading& reading) {
  const bool goes_on = !moments_.empty() && reading.time > moments_.back().time &&
                       reading.time - moments_.back().time < kMaxGap &&
                       reading.delivered_bytes >= moments_.back().delivered_bytes;
  if (!goes_on) {
    moments_.clear();
    full_since_.reset();
    last_arrival_ = reading.time;
  }
  const double seconds = goes_on ? seconds_of(reading.time - moments_.back().time) : 0;
  observe(reading);
  if (goes_on) {
    if (const auto delivered_per_s = overload(reading))
      cut(*delivered_per_s, reading.time);
    else
      grow(reading, seconds);
  }
  moments_.push_back({reading.time, reading.delivered_bytes, reading.resent_packets, rate_});
  while (moments_.front().time < reading.time - kMemory) moments_.pop_front();
}

/// Since when the line is full, and how short the way is.
void BandwidthEstimator::observe(const Reading& reading) {
  const bool arrived =
      !moments_.empty() && reading.delivered_bytes > moments_.back().delivered_bytes;
  const auto interruption = std::max<nanoseconds>(kInterruption, times(1.5, reading.round_trip));
  const bool was_interrupted = arrived && reading.time - last_arrival_ > interruption;
  if (arrived) last_arrival_ = reading.time;
  if (!reading.is_waiting || reading.is_probing_round_trip)
    full_since_.reset();
  else if (!full_since_ || was_interrupted)
    full_since_ = reading.time;
  if (reading.round_trip <= 0ns) return;
  if (least_round_trip_ != nanoseconds::max() && !moments_.empty()) {
    const double seconds = seconds_of(reading.time - moments_.back().time);
    least_round_trip_ = times(1 + kRoundTripAgeing * seconds, least_round_trip_);
  }
  least_round_trip_ = std::min(least_round_trip_, reading.round_trip);
}

/// The delivery rate of a full line, bytes/s, if it is less than the rate to send at.
std::optional<double> BandwidthEstimator::overload(const Reading& reading) const {
  if (!full_since_ || reading.time < next_cut_ || last_arrival_ != reading.time)
    return std::nullopt;
  const nanoseconds full = reading.time - *full_since_;
  const nanoseconds long_look =
      std::max<nanoseconds>(kLongLook, times(kRoundTripsOfLook, reading.round_trip));
  if (full < kShortLook) return std::nullopt;
  const nanoseconds look = std::min(full, long_look);
  const HostTime begin = reading.time - look;
  const double delivered = delivered_since(begin, reading);
  if (delivered < kMinBytesOfLook) return std::nullopt;
  const bool has_losses = has_resent_since(begin, reading);
  if (has_losses && full < long_look) return std::nullopt;
  const double per_s = has_losses ? best_part_since(begin, reading) : delivered / seconds_of(look);
  // Bytes that arrive now were sent a round trip ago, at the rate of that time.
  const double sent = std::min(rate_, rate_before(reading.time - reading.round_trip));
  const double least = full >= long_look ? kLess : kMuchLess;
  return per_s < least * sent ? std::optional(per_s) : std::nullopt;
}

void BandwidthEstimator::cut(double delivered_per_s, HostTime now) {
  capacity_ = delivered_per_s;
  rate_ = std::clamp(std::max(kCut * delivered_per_s, kMaxCut * rate_), kMin, kMax);
  growth_ = kCarefulGrowth;
  next_cut_ = now + kCutInterval;
  full_since_ = now;
}

void BandwidthEstimator::grow(const Reading& reading, double seconds) {
  const bool is_full = full_since_ && reading.time - *full_since_ >= kShortLook;
  if (reading.is_probing_round_trip || is_full) return;
  const double used = used_share(reading);
  if (used < kUsed) {
    const double proved = std::max(kStart, used / kUsed * rate_);
    if (rate_ > proved) rate_ = std::max(proved, rate_ * (1 - kAgeing * seconds));
    return;
  }
  // Pauses between frames may hide that the line is slower; BBR does not need a line that is full.
  if (reading.bbr_bytes_per_s > 0 && rate_ > reading.bbr_bytes_per_s)
    rate_ = std::max(kBelowBbr * reading.bbr_bytes_per_s, rate_ * (1 - kAgeing * seconds));
  if (has_queue(reading)) return;
  double grown = rate_ * std::exp(growth_per_s(seconds) * seconds) + kFairGrowth * seconds;
  if (reading.bbr_bytes_per_s > 0) grown = std::min(grown, kBelowBbr * reading.bbr_bytes_per_s);
  rate_ = std::clamp(std::max(rate_, grown), kMin, kMax);
}

double BandwidthEstimator::growth_per_s(double seconds) {
  if (capacity_ == 0)
    growth_ = kStartGrowth;
  else if (rate_ < kNear * capacity_)
    growth_ = kReturnGrowth;
  else if (rate_ < kBeyond * capacity_)
    growth_ = kCarefulGrowth;
  else
    growth_ = std::min(kMaxGrowth, growth_ * std::exp2(seconds / kGrowthDoubles_s));
  return growth_;
}

/// Of the rates of the last second; 1 until a second has passed.
double BandwidthEstimator::used_share(const Reading& reading) const {
  if (moments_.empty() || reading.time - moments_.front().time < kUseLook) return 1;
  double allowed = 0;
  HostTime until = reading.time;
  for (auto moment = moments_.rbegin(); moment != moments_.rend(); ++moment) {
    const HostTime from = std::max(moment->time, reading.time - kUseLook);
    if (until <= from) break;
    allowed += moment->rate * seconds_of(until - from);
    until = from;
  }
  return delivered_since(reading.time - kUseLook, reading) / allowed;
}

bool BandwidthEstimator::has_queue(const Reading& reading) const {
  if (least_round_trip_ == nanoseconds::max()) return false;
  return reading.round_trip > times(1 + kQueueShare, least_round_trip_) + kQueue;
}

double BandwidthEstimator::rate_before(HostTime time) const {
  for (auto moment = moments_.rbegin(); moment != moments_.rend(); ++moment)
    if (moment->time <= time) return moment->rate;
  return moments_.empty() ? rate_ : moments_.front().rate;
}

double BandwidthEstimator::delivered_since(HostTime begin, const Reading& reading) const {
  const Moment* from = nullptr;
  for (const Moment& moment : moments_) {
    if (from != nullptr && moment.time > begin) break;
    from = &moment;
  }
  return from == nullptr ? 0 : static_cast<double>(reading.delivered_bytes - from->delivered_bytes);
}

bool BandwidthEstimator::has_resent_since(HostTime begin, const Reading& reading) const {
  const auto first = std::ranges::find_if(
      moments_, [begin](const Moment& moment) { return moment.time >= begin; });
  return first != moments_.end() && reading.resent_packets != first->resent_packets;
}

/// The highest delivery rate over a part of the time since then, bytes/s.
double BandwidthEstimator::best_part_since(HostTime begin, const Reading& reading) const {
  double best = 0;
  auto from = std::ranges::find_if(moments_,
                                   [begin](const Moment& moment) { return moment.time >= begin; });
  const auto consider = [&](HostTime time, std::uint64_t delivered_bytes) {
    while (from != moments_.end() && time - from->time >= kPartOfLook) {
      best = std::max(best, static_cast<double>(delivered_bytes - from->delivered_bytes) /
                                seconds_of(time - from->time));
      ++from;
    }
  };
  for (const Moment& moment : moments_) consider(moment.time, moment.delivered_bytes);
  consider(reading.time, reading.delivered_bytes);
  return best;
}

}  // namespace roomcast::client
