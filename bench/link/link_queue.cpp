// SPDX-License-Identifier: Apache-2.0
#include "bench/link/link_queue.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace roomcast::bench {
namespace {

constexpr double kFullPacketBytes = 1500;

}  // namespace

LinkQueue::LinkQueue(const LinkSpec& spec, std::uint32_t seed) : spec_(spec), random_(seed) {}

bool LinkQueue::is_lost(Time now) {
  if (spec_.loss_burst <= 1) return std::uniform_real_distribution<>()(random_) < spec_.loss;
  if (!loses_until_) loses_until_ = now + until_change();
  while (*loses_until_ <= now) {
    loses_ = !loses_;
    *loses_until_ += until_change();
  }
  return loses_;
}

/// How long a burst lasts that begins now, or the time without losses.
LinkQueue::Time::duration LinkQueue::until_change() {
  const double packet_s = kFullPacketBytes * 8e-6 / spec_.mbit_per_s;
  const double burst_s = -packet_s / std::log1p(-1 / spec_.loss_burst);
  const double mean_s = loses_ ? burst_s : burst_s * (1 - spec_.loss) / spec_.loss;
  const std::chrono::duration<double> time(std::exponential_distribution<>(1 / mean_s)(random_));
  return std::chrono::duration_cast<Time::duration>(time) + Time::duration(1);
}

void LinkQueue::push(Time now, std::span<const std::uint8_t> packet) {
  if (spec_.loss > 0 && is_lost(now)) return;
  const Time begin = std::max({now, free_at_, up_at_});
  if (begin - std::max(now, up_at_) > spec_.queue) return;
  const std::chrono::duration<double, std::micro> on_the_wire(static_cast<double>(packet.size()) *
                                                              8 / spec_.mbit_per_s);
  free_at_ = begin + std::chrono::duration_cast<Time::duration>(on_the_wire);
  travelling_.push_back({free_at_ + spec_.round_trip / 2, {packet.begin(), packet.end()}});
  carried_bytes_ += packet.size();
}

void LinkQueue::set_rate(Time now, double mbit_per_s) {
  const double slower = spec_.mbit_per_s / mbit_per_s;
  const auto delayed = [&](Time leaves) {
    if (leaves <= now) return leaves;
    const std::chrono::duration<double> rest = leaves - now;
    return now + std::chrono::duration_cast<Time::duration>(slower * rest);
  };
  const Time::duration way = spec_.round_trip / 2;
  for (Travelling& packet : travelling_) packet.arrival = delayed(packet.arrival - way) + way;
  free_at_ = delayed(free_at_);
  spec_.mbit_per_s = mbit_per_s;
}

void LinkQueue::stop_for(Time now, Time::duration duration) {
  up_at_ = now + duration;
  const Time::duration way = spec_.round_trip / 2;
  for (Travelling& packet : travelling_) {
    if (packet.arrival - way > now) packet.arrival += duration;
  }
  if (free_at_ > now) free_at_ += duration;
}

std::optional<LinkQueue::Packet> LinkQueue::pop(Time now) {
  if (travelling_.empty() || travelling_.front().arrival > now) return std::nullopt;
  Packet packet = std::move(travelling_.front().packet);
  travelling_.pop_front();
  return packet;
}

std::optional<LinkQueue::Time> LinkQueue::next_arrival() const {
  if (travelling_.empty()) return std::nullopt;
  return travelling_.front().arrival;
}

}  // namespace roomcast::bench
