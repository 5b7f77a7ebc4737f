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
// Near the last capacity all who share a line grow by the same bytes, and each cut takes the same
// part of each: so the rates of who sends more and who sends less approach each other.
constexpr double kCarefulBytes = 25'000;  // per second, each second
constexpr double kMaxCarefulGrowth = 0.35;
constexpr double kNear = 0.85, kBeyond = 1.04;  // of the last capacity
constexpr double kGrowthDoubles_s = 0.25;
constexpr double kBelowBbr = 0.95;

constexpr auto kUseLook = 1s;
constexpr double kUsed = 0.7;              // of the rate; a rate that is not used is not proved
constexpr double kAgeing = 0.1;            // per second, of a rate that is not used
constexpr double kRoundTripAgeing = 0.01;  // per second: the way may have become longer

// A queue is what a round trip takes longer than the least one, by more than other senders' frames
// add. It stands if it has not been shorter for a while, or a shorter while if it overflows.
constexpr auto kQueue = 30ms;
constexpr double kQueueShare = 0.25;  // of the least round trip
constexpr auto kStandingLook = 400ms, kOverflowLook = 200ms;
constexpr double kDrain_s = 1;  // in which the queue leaves
constexpr double kMinDrain = 0.75;

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
  room_ = room_in_queue(reading);
  if (goes_on) {
    if (const auto delivered_per_s = overload(reading))
      cut(*delivered_per_s, reading.time);
    else if (!drain(reading))
      grow(reading, seconds);
  }
  moments_.push_back(
      {reading.time, reading.delivered_bytes, reading.resent_packets, reading.round_trip, rate_});
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
  const nanoseconds least_look = room_ > 0 ? long_look : nanoseconds(kOverflowLook);
  if (has_losses && full < least_look) return std::nullopt;
  const double per_s = has_losses ? best_part_since(begin, reading) : delivered / seconds_of(look);
  // Bytes that arrive now were sent a round trip ago, at the rate of that time.
  const double sent = std::min(rate_, rate_before(reading.time - reading.round_trip));
  const double least = full >= long_look ? kLess : kMuchLess;
  return per_s < least * sent ? std::optional(per_s) : std::nullopt;
}

void BandwidthEstimator::cut(double delivered_per_s, HostTime now) {
  capacity_ = delivered_per_s;
  rate_ = std::clamp(std::max(kCut * delivered_per_s, kMaxCut * rate_), kMin, kMax);
  growth_ = careful_growth_per_s();
  next_cut_ = now + kCutInterval;
  full_since_ = now;
}

/// The shortest queue of this look; 0: there is not so much to look back on.
nanoseconds BandwidthEstimator::standing_queue(const Reading& reading, nanoseconds look) const {
  if (least_round_trip_ == nanoseconds::max() || moments_.empty() ||
      moments_.front().time > reading.time - look)
    return 0ns;
  nanoseconds least = reading.round_trip;
  for (auto moment = moments_.rbegin();
       moment != moments_.rend() && moment->time >= reading.time - look; ++moment)
    least = std::min(least, moment->round_trip);
  return least - least_round_trip_;
}

/// Cuts the rate while a queue stands. Senders that share a line may each find the time to send all
/// they have while together they keep its queue full, so that none takes the line for full. What is
/// delivered is then this one's share of the line, and a little less lets the queue leave.
bool BandwidthEstimator::drain(const Reading& reading) {
  if (reading.is_probing_round_trip || reading.time < next_drain_) return false;
  const bool has_losses = has_resent_since(reading.time - kOverflowLook, reading);
  const nanoseconds look = has_losses ? kOverflowLook : kStandingLook;
  const nanoseconds queue = standing_queue(reading, look);
  if (queue <= longest_passing_queue()) return false;
  const double delivered = delivered_since(reading.time - look, reading);
  if (delivered < kMinBytesOfLook) return false;
  const double per_s =
      has_losses ? best_part_since(reading.time - look, reading) : delivered / seconds_of(look);
  const double rate = per_s * std::max(1 - seconds_of(queue) / kDrain_s, kMinDrain);
  if (rate >= rate_) return false;
  capacity_ = per_s;
  rate_ = std::max({rate, kMaxCut * rate_, kMin});
  growth_ = careful_growth_per_s();
  next_drain_ = next_cut_ = reading.time + kStandingLook;
  return true;
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
  if (room_ <= 0) return;
  const double growth = room_ * room_ * growth_per_s(room_ * seconds);
  double grown = rate_ * std::exp(growth * seconds);
  if (reading.bbr_bytes_per_s > 0) grown = std::min(grown, kBelowBbr * reading.bbr_bytes_per_s);
  rate_ = std::clamp(std::max(rate_, grown), kMin, kMax);
}

double BandwidthEstimator::growth_per_s(double seconds) {
  if (capacity_ == 0)
    growth_ = kStartGrowth;
  else if (rate_ < kNear * capacity_)
    growth_ = kReturnGrowth;
  else if (rate_ < kBeyond * capacity_)
    growth_ = careful_growth_per_s();
  else
    growth_ = std::min(kMaxGrowth, growth_ * std::exp2(seconds / kGrowthDoubles_s));
  return growth_;
}

double BandwidthEstimator::careful_growth_per_s() const {
  return std::min(kMaxCarefulGrowth, kCarefulBytes / rate_);
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

/// What a line without a lasting queue may show for a moment.
nanoseconds BandwidthEstimator::longest_passing_queue() const {
  return times(kQueueShare, least_round_trip_) + kQueue;
}

double BandwidthEstimator::room_in_queue(const Reading& reading) const {
  if (least_round_trip_ == nanoseconds::max()) return 1;
  const double queue_s = seconds_of(reading.round_trip - least_round_trip_);
  return std::clamp(1 - queue_s / seconds_of(longest_passing_queue()), 0.0, 1.0);
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
