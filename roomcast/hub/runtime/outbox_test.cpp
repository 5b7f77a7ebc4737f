// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/outbox.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr SensorId kSensor{0}, kOther{1};

net::SealedMessagePtr some_message() {
  return net::seal(net::MessageBuffer(std::vector<std::uint8_t>{1, 2, 3}));
}

struct FrameSpec {
  SensorId sensor;
  std::uint32_t seq;
  std::uint32_t base_seq;
  std::uint8_t layer = 0;
};

FrameSetPtr set_of(std::vector<FrameSpec> specs) {
  auto set = std::make_shared<FrameSet>();
  for (const auto& spec : specs) {
    wire::FrameHeader header{.key = spec.seq == spec.base_seq,
                             .sensor = spec.sensor,
                             .layer = spec.layer,
                             .seq = spec.seq,
                             .base_seq = spec.base_seq};
    set->frames.push_back({header, some_message()});
  }
  return set;
}

int drain(Outbox& outbox) {
  int messages = 0;
  while (outbox.next() != nullptr) ++messages;
  return messages;
}

TEST(Outbox, control_goes_before_frames) {
  Outbox outbox;
  const auto set = set_of({{kSensor, 0, 0}});
  outbox.push_set(set);
  const auto control = some_message();
  ASSERT_TRUE(outbox.push_control(control));
  EXPECT_EQ(outbox.next(), control);
  EXPECT_EQ(outbox.next(), set->frames[0].message);
  EXPECT_EQ(outbox.next(), nullptr);
}

TEST(Outbox, the_oldest_unbegun_set_gives_way) {
  Outbox outbox;
  std::vector<FrameSetPtr> sets;
  for (std::uint32_t i = 0; i < 5; ++i) {
    sets.push_back(set_of({{kSensor, i, i}}));
    outbox.push_set(sets.back());
  }
  EXPECT_EQ(outbox.dropped_sets(), 5 - wire::kMaxQueuedSets);
  EXPECT_EQ(outbox.next(), sets[3]->frames[0].message);
  EXPECT_EQ(outbox.next(), sets[4]->frames[0].message);
}

TEST(Outbox, sets_of_upper_layers_give_way_first) {
  Outbox outbox;
  outbox.push_set(set_of({{kSensor, 0, 0}, {kOther, 0, 0}}));
  EXPECT_EQ(drain(outbox), 2);
  const auto base = set_of({{kSensor, 1, 0}, {kOther, 1, 0}});
  outbox.push_set(base);
  outbox.push_set(set_of({{kSensor, 2, 1, 1}, {kOther, 2, 1, 1}}));  // gives way
  const auto next_base = set_of({{kSensor, 3, 1}, {kOther, 3, 1}});
  outbox.push_set(next_base);
  EXPECT_EQ(outbox.next(), base->frames[0].message);
  EXPECT_EQ(outbox.next(), base->frames[1].message);
  EXPECT_EQ(outbox.next(), next_base->frames[0].message);
  EXPECT_EQ(drain(outbox), 1);
  EXPECT_THAT(outbox.take_key_needs(), IsEmpty());
}

// Sensors that are not in step: in every set one sends a base frame and the other does not.
TEST(Outbox, of_mixed_sets_the_upper_layers_give_way_and_nothing_breaks) {
  Outbox outbox;
  outbox.push_set(set_of({{kSensor, 0, 0}, {kOther, 0, 0}}));
  EXPECT_EQ(drain(outbox), 2);
  outbox.push_set(set_of({{kSensor, 1, 0}, {kOther, 1, 0, 1}}));
  outbox.push_set(set_of({{kSensor, 2, 1, 1}, {kOther, 2, 0}}));
  outbox.push_set(set_of({{kSensor, 3, 1}, {kOther, 3, 2, 1}}));
  outbox.push_set(set_of({{kSensor, 4, 3, 1}, {kOther, 4, 2}}));
  EXPECT_EQ(drain(outbox), 4) << "four base frames, two sets' worth";
  EXPECT_EQ(outbox.dropped_sets(), 0U);
  EXPECT_THAT(outbox.take_key_needs(), IsEmpty());
}

TEST(Outbox, base_frames_are_bounded_too) {
  Outbox outbox;
  outbox.push_set(set_of({{kSensor, 0, 0}, {kOther, 0, 0}}));
  EXPECT_EQ(drain(outbox), 2);
  for (std::uint32_t seq = 1; seq <= 100; ++seq) {
    outbox.push_set(set_of({{kSensor, seq, seq}, {kOther, seq, 0, 1}}));
  }
  EXPECT_LE(drain(outbox), 2 * static_cast<int>(wire::kMaxQueuedSets));
}

TEST(Outbox, a_set_that_has_begun_is_finished) {
  Outbox outbox;
  const auto begun = set_of({{kSensor, 0, 0}, {kOther, 0, 0}});
  outbox.push_set(begun);
  EXPECT_EQ(outbox.next(), begun->frames[0].message);
  for (std::uint32_t i = 1; i < 6; ++i) outbox.push_set(set_of({{kSensor, i, i}}));
  EXPECT_EQ(outbox.next(), begun->frames[1].message);
}

TEST(Outbox, the_first_frame_has_to_be_a_key_frame) {
  Outbox outbox;
  outbox.push_set(set_of({{kSensor, 8, 7}}));
  EXPECT_EQ(drain(outbox), 0);
  EXPECT_THAT(outbox.take_key_needs(), ElementsAre(kSensor));
  outbox.push_set(set_of({{kSensor, 9, 9}}));
  EXPECT_EQ(drain(outbox), 1);
}

TEST(Outbox, after_a_lost_base_frame_nothing_goes_out_up_to_the_next_key_frame) {
  Outbox outbox;
  outbox.push_set(set_of({{kSensor, 0, 0}}));
  EXPECT_EQ(drain(outbox), 1);
  for (std::uint32_t seq = 1; seq <= 3; ++seq)
    outbox.push_set(set_of({{kSensor, seq, seq - 1}}));  // 1 is dropped
  EXPECT_EQ(drain(outbox), 0);
  EXPECT_THAT(outbox.take_key_needs(), ElementsAre(kSensor));
  outbox.push_set(set_of({{kSensor, 4, 3}}));
  EXPECT_EQ(drain(outbox), 0);
  EXPECT_THAT(outbox.take_key_needs(), IsEmpty()) << "a gap is reported once";
  outbox.push_set(set_of({{kSensor, 5, 5}}));
  outbox.push_set(set_of({{kSensor, 6, 5}}));
  EXPECT_EQ(drain(outbox), 2);
}

TEST(Outbox, a_lost_droppable_frame_harms_nothing) {
  Outbox outbox;
  outbox.push_set(set_of({{kSensor, 0, 0}}));
  EXPECT_EQ(drain(outbox), 1);
  outbox.push_set(set_of({{kSensor, 1, 0, 1}}));  // gives way
  outbox.push_set(set_of({{kSensor, 2, 0}}));
  outbox.push_set(set_of({{kSensor, 3, 2, 1}}));
  EXPECT_EQ(drain(outbox), 2);
  EXPECT_THAT(outbox.take_key_needs(), IsEmpty());
}

TEST(Outbox, sensors_do_not_harm_each_other) {
  Outbox outbox;
  outbox.push_set(set_of({{kSensor, 0, 0}, {kOther, 5, 4}}));
  EXPECT_EQ(drain(outbox), 1);
  EXPECT_THAT(outbox.take_key_needs(), ElementsAre(kOther));
}

TEST(Outbox, a_sensor_that_starts_anew_has_to_begin_with_a_key_frame) {
  Outbox outbox;
  outbox.push_set(set_of({{kSensor, 4, 4}}));
  EXPECT_EQ(drain(outbox), 1);
  outbox.forget(kSensor);
  outbox.push_set(set_of({{kSensor, 5, 4}}));
  EXPECT_EQ(drain(outbox), 0);
}

TEST(Outbox, control_messages_are_bounded) {
  Outbox outbox;
  for (std::size_t i = 0; i < wire::kMaxQueuedControlMessages; ++i)
    EXPECT_TRUE(outbox.push_control(some_message()));
  EXPECT_FALSE(outbox.push_control(some_message()));
}

}  // namespace
}  // namespace roomcast::hub
