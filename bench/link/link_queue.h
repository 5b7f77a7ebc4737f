// SPDX-License-Identifier: Apache-2.0
// LinkQueue: one direction of an emulated link. Packets leave at a given rate, are lost at random
// or in bursts, wait in a queue that drops packets when it is full, and arrive after a delay. Pure;
// time is an argument. Source: the model of Linux netem and tbf; bursts by Gilbert (1960), in time:
// a burst ends whether packets are sent or not, whereas netem's waits for the next packets.
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
  double loss = 0;                           // share of the packets that are lost
  double loss_burst = 1;  // full packets that are lost in a row, on average, while the line is full
  std::chrono::milliseconds queue{100};  // packets that would wait longer are dropped
  std::uint32_t seed = 1;
};

class LinkQueue {
 public:
  using Time = std::chrono::steady_clock::time_point;
  using Packet = std::vector<std::uint8_t>;

  LinkQueue(const LinkSpec& spec, std::uint32_t seed);

  /// Queues or drops a packet.
  void push(Time now, std::span<const std::uint8_t> packet);
  /// The next packet that has arrived by `now`.
  [[nodiscard]] std::optional<Packet> pop(Time now);
  /// The time at which pop() will next return a packet, if no packet is added.
  [[nodiscard]] std::optional<Time> next_arrival() const;

  /// The line carries so much from now on; what waits in the queue leaves at the new rate.
  void set_rate(Time now, double mbit_per_s);

  /// Nothing leaves for so long, as on a radio link that has lost its station: packets wait, as
  /// many as the queue takes.
  void stop_for(Time now, Time::duration duration);

  [[nodiscard]] std::uint64_t carried_bytes() const { return carried_bytes_; }

 private:
  struct Travelling {
    Time arrival;
    Packet packet;
  };
  [[nodiscard]] bool is_lost(Time now);
  [[nodiscard]] Time::duration until_change();

  LinkSpec spec_;
  bool loses_ = false;               // there is a burst of losses
  std::optional<Time> loses_until_;  // or does not, until then
  Time up_at_{};                     // it stands still until then
  std::minstd_rand random_;
  Time free_at_{};  // when the last queued packet will have left
  std::deque<Travelling> travelling_;
  std::uint64_t carried_bytes_ = 0;
};

}  // namespace roomcast::bench
