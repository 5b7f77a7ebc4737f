// SPDX-License-Identifier: Apache-2.0
// LinkQueue: one direction of an emulated link: packets leave at a given rate, are lost at random,
// wait in a queue that drops what it cannot hold, and arrive after a delay. Pure; time comes in as
// an argument. Source: the model of Linux netem and tbf, which many kernels come without.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace roomcast::bench {

struct LinkSpec {
  double mbit_per_s = 20;
  std::chrono::milliseconds round_trip{50};  // half of it each way
  double loss = 0;                           // share of packets, each by itself
  std::chrono::milliseconds queue{100};      // longer than this nothing waits: it is dropped
  std::uint32_t seed = 1;
};

class LinkQueue {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Packet = std::vector<std::uint8_t>;

  LinkQueue(const LinkSpec& spec, std::uint32_t seed);

  /// A packet comes in: queued, or gone.
  void push(Time now, std::span<const std::uint8_t> packet);
  /// The next one that has arrived by `now`.
  [[nodiscard]] std::optional<Packet> pop(Time now);
  /// When pop() will next have something, if nothing else comes in.
  [[nodiscard]] std::optional<Time> next_arrival() const;

  [[nodiscard]] std::uint64_t carried_bytes() const { return carried_bytes_; }

 private:
  struct Travelling {
    Time arrival;
    Packet packet;
  };
  const LinkSpec spec_;
  std::minstd_rand random_;
  Time free_at_{};  // when the last one in will have left
  std::deque<Travelling> travelling_;
  std::uint64_t carried_bytes_ = 0;
};

}  // namespace roomcast::bench
