// SPDX-License-Identifier: Apache-2.0
#include "bench/link/link_queue.h"

#include <gtest/gtest.h>

namespace roomcast::bench {
namespace {

using namespace std::chrono_literals;
const LinkQueue::Time kBegin{1h};
const LinkQueue::Packet kPacket(1250);  // 10 000 bits: 1 ms at 10 Mbit/s

LinkSpec ten_mbit() {
  return {.mbit_per_s = 10, .round_trip = 50ms, .loss = 0, .queue = 5ms};
}

TEST(LinkQueue, a_packet_takes_its_time_on_the_wire_and_half_a_round_trip) {
  LinkQueue link(ten_mbit(), 1);
  link.push(kBegin, kPacket);
  EXPECT_EQ(link.next_arrival(), kBegin + 26ms);
  EXPECT_FALSE(link.pop(kBegin + 25ms));
  EXPECT_EQ(link.pop(kBegin + 26ms), kPacket);
  EXPECT_FALSE(link.next_arrival());
}

TEST(LinkQueue, packets_leave_one_after_the_other) {
  LinkQueue link(ten_mbit(), 1);
  link.push(kBegin, kPacket);
  link.push(kBegin, kPacket);
  ASSERT_TRUE(link.pop(kBegin + 26ms));
  EXPECT_EQ(link.next_arrival(), kBegin + 27ms);
}

TEST(LinkQueue, a_packet_that_would_wait_too_long_is_dropped) {
  LinkQueue link(ten_mbit(), 1);
  for (int i = 0; i < 20; ++i) link.push(kBegin, kPacket);
  EXPECT_EQ(link.carried_bytes(), 6 * kPacket.size()) << "one on the wire and five in the queue";
}

TEST(LinkQueue, a_slower_line_delays_what_waits) {
  LinkQueue link(ten_mbit(), 1);
  for (int i = 0; i < 3; ++i) link.push(kBegin, kPacket);
  link.set_rate(kBegin + 1ms, 2.5);
  EXPECT_TRUE(link.pop(kBegin + 26ms)) << "it had left";
  EXPECT_EQ(link.next_arrival(), kBegin + 30ms);
  EXPECT_TRUE(link.pop(kBegin + 30ms));
  EXPECT_EQ(link.next_arrival(), kBegin + 34ms);
  link.push(kBegin + 9ms, kPacket);
  link.set_rate(kBegin + 9ms, 10);
  EXPECT_TRUE(link.pop(kBegin + 34ms));
  EXPECT_EQ(link.next_arrival(), kBegin + 35ms);
}

TEST(LinkQueue, loses_the_requested_share) {
  LinkSpec spec = ten_mbit();
  spec.loss = 0.1;
  LinkQueue link(spec, 7);
  for (int i = 0; i < 10'000; ++i) link.push(kBegin + i * 2ms, kPacket);
  const double lost = 1 - static_cast<double>(link.carried_bytes()) / (10'000.0 * 1250);
  EXPECT_NEAR(lost, 0.1, 0.01);
}

TEST(LinkQueue, loses_packets_in_bursts_of_the_requested_length) {
  LinkSpec spec = ten_mbit();
  spec.loss = 0.05;
  spec.loss_burst = 4;
  LinkQueue link(spec, 7);
  int lost = 0, bursts = 0;
  bool was_lost = false;
  for (int i = 0; i < 100'000; ++i) {
    const auto before = link.carried_bytes();
    link.push(kBegin + i * 1200us, kPacket);  // as full packets at 10 Mbit/s
    const bool is_lost = link.carried_bytes() == before;
    lost += is_lost;
    bursts += is_lost && !was_lost;
    was_lost = is_lost;
  }
  EXPECT_NEAR(lost / 100'000.0, 0.05, 0.005);
  EXPECT_NEAR(static_cast<double>(lost) / bursts, 4, 0.4);
}

TEST(LinkQueue, a_burst_of_losses_ends_while_nobody_sends) {
  LinkSpec spec = ten_mbit();
  spec.loss = 0.05;
  spec.loss_burst = 4;
  LinkQueue link(spec, 7);
  int lost = 0, in_a_row = 0;
  bool was_lost = false;
  for (int i = 0; i < 20'000; ++i) {
    const auto before = link.carried_bytes();
    link.push(kBegin + i * 100ms, kPacket);
    const bool is_lost = link.carried_bytes() == before;
    lost += is_lost;
    in_a_row += is_lost && was_lost;
    was_lost = is_lost;
  }
  EXPECT_NEAR(lost / 20'000.0, 0.05, 0.005);
  EXPECT_NEAR(in_a_row / static_cast<double>(lost), 0.05, 0.02) << "by chance only";
}

TEST(LinkQueue, while_it_stands_still_packets_wait_as_many_as_the_queue_takes) {
  LinkQueue link(ten_mbit(), 1);
  link.push(kBegin, kPacket);
  link.push(kBegin, kPacket);
  link.stop_for(kBegin + 1500us, 300ms);
  EXPECT_TRUE(link.pop(kBegin + 26ms)) << "it had left";
  EXPECT_EQ(link.next_arrival(), kBegin + 327ms);
  for (int i = 0; i < 20; ++i) link.push(kBegin + 100ms, kPacket);
  EXPECT_EQ(link.carried_bytes(), 2 * kPacket.size() + 5 * kPacket.size());
}

}  // namespace
}  // namespace roomcast::bench
