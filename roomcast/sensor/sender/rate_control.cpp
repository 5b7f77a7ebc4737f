// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/sender/rate_control.h"

#include <algorithm>
#include <chrono>

namespace roomcast::sensor {
namespace {

using Seconds = std::chrono::duration<double>;

constexpr double kMaxSaved_s = 0.1;  // of bytes that were not used and may be spent later
constexpr double kRepay_s = 0.6;     // in which frames that were too large or small are balanced
constexpr double kMinShare = 0.3;    // of a frame's even share, however much waits
constexpr double kMaxShare = 2.0;
constexpr double kKeyCost_s = 0.3;  // that a key frame may occupy the line
constexpr double kKeyShare = 0.01;  // of all bytes that go into key frames that nobody asked for
constexpr double kMinKeyInterval_s = 10, kMaxKeyInterval_s = 300;
constexpr double kIntervalWeight = 0.05;
constexpr double kMinInterval_s = 1.0 / 240, kMaxInterval_s = 1;

// The frame rate is halved after a while at the coarsest quality, and doubled after a longer one at
// a quality that would stay good.
constexpr double kSqueezed = 0.8;        // of its even share: a frame that says nothing of the rate
constexpr int kCoarse = 56, kFine = 44;  // FrameQuality's quantiser
constexpr Seconds kCoarseFor{0.8}, kFineFor{3};
constexpr double kFaster = 1.35;  // than when it was halved: a line that carries twice the frames

/// Whether a condition has held for `enough`; `since` is its memory.
bool has_held(bool holds, HostTime now, Seconds enough, std::optional<HostTime>& since) {
  if (!holds) {
    since.reset();
    return false;
  }
  if (!since) since = now;
  return now - *since >= enough;
}

}  // namespace

RateControl::RateControl(const Options& options)
    : options_(options), source_interval_s_(1 / options.fps) {}

void RateControl::drain(HostTime now) {
  if (last_frame_ && now > *last_frame_)
    waiting_bytes_ -= options_.bytes_per_s * Seconds(now - *last_frame_).count();
  waiting_bytes_ = std::max(waiting_bytes_, -kMaxSaved_s * options_.bytes_per_s);
}

void RateControl::learn_interval(HostTime now) {
  if (!last_frame_ || now <= *last_frame_) return;
  const double interval_s = Seconds(now - *last_frame_).count();
  if (interval_s > kMaxInterval_s) return;  // a pause
  source_interval_s_ += kIntervalWeight * (interval_s - source_interval_s_);
  source_interval_s_ = std::max(source_interval_s_, kMinInterval_s);
}

double RateControl::reserve_s() const {
  return std::max(options_.reserve_s, options_.reserve_frames * source_interval_s_);
}

std::optional<RateControl::Plan> RateControl::next_frame(HostTime now,
                                                         std::uint64_t control_bytes) {
  drain(now);
  learn_interval(now);
  last_frame_ = now;
  waiting_bytes_ += static_cast<double>(control_bytes - control_bytes_);
  control_bytes_ = control_bytes;
  if (line_waiting_bytes_) waiting_bytes_ = *line_waiting_bytes_;
  choose_divisor(now);
  if (!is_due()) return std::nullopt;
  const double share = options_.bytes_per_s * frame_interval_s();
  const double missing = options_.bytes_per_s * reserve_s() - waiting_bytes_;
  const double wanted = share + missing * std::min(1.0, frame_interval_s() / kRepay_s);
  Plan plan;
  plan.target.bytes = std::clamp(wanted, kMinShare * share, kMaxShare * share);
  is_squeezed_ = plan.target.bytes < kSqueezed * share;
  plan.target.key_bytes = std::max(share, options_.bytes_per_s * kKeyCost_s);
  plan.wants_key = next_key_ && now >= *next_key_;
  return plan;
}

bool RateControl::is_due() {
  if (++since_sent_ < divisor()) return false;
  return waiting_bytes_ <= options_.bytes_per_s * (reserve_s() + 0.5 * source_interval_s_);
}

void RateControl::sent(std::size_t bytes, const codec::EncodedFrameInfo& info) {
  since_sent_ = 0;
  waiting_bytes_ += static_cast<double>(bytes);
  if (!info.key) {
    quantizer_ = is_squeezed_ ? 0 : info.quantizer;
    return;
  }
  const double interval_s =
      std::clamp(static_cast<double>(bytes) / options_.bytes_per_s / kKeyShare, kMinKeyInterval_s,
                 kMaxKeyInterval_s);
  next_key_ = *last_frame_ + std::chrono::duration_cast<nanoseconds>(Seconds(interval_s));
}

void RateControl::choose_divisor(HostTime now) {
  const bool coarse = quantizer_ >= kCoarse && divisor() < kMaxDivisor;
  const bool fine = quantizer_ > 0 && quantizer_ <= kFine && divisor() > 1;
  const bool halve = has_held(coarse, now, kCoarseFor, coarse_since_);
  const bool twice = has_held(fine, now, kFineFor, fine_since_) ||
                     (divisor() > 1 && options_.bytes_per_s > kFaster * halved_at_.back());
  if (!halve && !twice) return;
  if (twice)
    halved_at_.pop_back();
  else
    halved_at_.push_back(options_.bytes_per_s);
  coarse_since_.reset();
  fine_since_.reset();
}

}  // namespace roomcast::sensor
