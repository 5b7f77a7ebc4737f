// SPDX-License-Identifier: Apache-2.0
#include "bench/link/link_queue.h"

#include <algorithm>
#include <utility>

namespace roomcast::bench {

LinkQueue::LinkQueue(const LinkSpec& spec, std::uint32_t seed) : spec_(spec), random_(seed) {}

bool LinkQueue::is_lost() {
  double chance = spec_.loss;
  if (spec_.loss_burst > 1) {
    const double ends = 1 / spec_.loss_burst;
    chance = loses_ ? 1 - ends : spec_.loss * ends / (1 - spec_.loss);
  }
  return loses_ = std::uniform_real_distribution<>()(random_) < chance;
}

void LinkQueue::push(Time now, std::span<const std::uint8_t> packet) {
  if (is_lost()) return;
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
