// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/runtime/send_queue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/hub/runtime/send_queue_fixture.h"
#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SendQueue, control_messages_precede_frames) {
  SendQueue send_queue;
  const auto set = frame_set_of({{kSensor, 0, 0}});
  send_queue.push_set(set);
  const auto control = some_message();
  ASSERT_TRUE(send_queue.push_control(control));
  EXPECT_EQ(send_queue.next(), control);
  EXPECT_EQ(send_queue.next(), set->frames[0].message);
  EXPECT_EQ(send_queue.next(), nullptr);
}

TEST(SendQueue, audio_comes_after_control_messages_and_before_frames) {
  SendQueue send_queue;
  const auto set = frame_set_of({{kSensor, 0, 0}, {kOtherSensor, 0, 0}});
  send_queue.push_set(set);
  EXPECT_EQ(send_queue.next(), set->frames[0].message);
  const auto audio = some_message(), control = some_message();
  send_queue.push_audio(ViewerId{1}, audio);
  ASSERT_TRUE(send_queue.push_control(control));
  EXPECT_EQ(send_queue.next(), control);
  EXPECT_EQ(send_queue.next(), audio) << "even within a set";
  EXPECT_EQ(send_queue.next(), set->frames[1].message);
}

TEST(SendQueue, old_audio_of_a_speaker_is_dropped_and_no_frame_and_no_other_speaker) {
  SendQueue send_queue;
  const auto set = frame_set_of({{kSensor, 0, 0}});
  send_queue.push_set(set);
  const auto other = some_message();
  send_queue.push_audio(ViewerId{2}, other);
  std::vector<net::FramedMessagePtr> packets;
  for (std::size_t i = 0; i < wire::kMaxQueuedAudioPackets + 3; ++i) {
    packets.push_back(some_message());
    send_queue.push_audio(ViewerId{1}, packets.back());
  }
  EXPECT_EQ(send_queue.dropped_audio(), 3U);
  EXPECT_EQ(send_queue.next(), other);
  for (std::size_t i = 3; i < packets.size(); ++i) EXPECT_EQ(send_queue.next(), packets[i]);
  EXPECT_EQ(send_queue.next(), set->frames[0].message);
  EXPECT_EQ(send_queue.dropped_sets(), 0U);
}

TEST(SendQueue, audio_of_ever_new_speakers_is_bounded) {
  SendQueue send_queue;
  for (std::uint32_t speaker = 0; speaker < 1000; ++speaker)
    send_queue.push_audio(ViewerId{speaker}, some_message());
  EXPECT_EQ(drain(send_queue),
            static_cast<int>(wire::kMaxQueuedAudioPackets * wire::kMaxSpeakersHeard));
}

TEST(SendQueue, drops_the_oldest_unstarted_set) {
  SendQueue send_queue;
  std::vector<FrameSetPtr> sets;
  for (std::uint32_t i = 0; i < 5; ++i) {
    sets.push_back(frame_set_of({{kSensor, i, i}}));
    send_queue.push_set(sets.back());
  }
  EXPECT_EQ(send_queue.dropped_sets(), 5 - wire::kMaxQueuedSets);
  EXPECT_EQ(send_queue.next(), sets[3]->frames[0].message);
  EXPECT_EQ(send_queue.next(), sets[4]->frames[0].message);
}

TEST(SendQueue, a_set_whose_last_frame_is_left_out_has_an_end) {
  SendQueue send_queue;
  send_queue.set_details({Detail::kAll, Detail::kPaused});
  const auto set = frame_set_of({{kSensor, 0, 0}, {kOtherSensor, 0, 0}}, some_message());
  send_queue.push_set(set);
  EXPECT_EQ(send_queue.next(), set->frames[0].message);
  EXPECT_EQ(send_queue.next(), set->end);
  EXPECT_EQ(send_queue.next(), nullptr);
  const auto other_order = frame_set_of({{kOtherSensor, 0, 0}, {kSensor, 1, 1}}, some_message());
  send_queue.push_set(other_order);
  EXPECT_EQ(send_queue.next(), other_order->frames[1].message);
  EXPECT_EQ(send_queue.next(), nullptr) << "the last frame has come";
  send_queue.push_set(frame_set_of({{kOtherSensor, 1, 1}}, some_message()));
  EXPECT_EQ(send_queue.next(), nullptr) << "nothing of it has come";
}

TEST(SendQueue, a_sensor_in_its_base_loses_upper_layers_only) {
  SendQueue send_queue;
  send_queue.set_details({Detail::kBaseOnly});
  for (std::uint32_t seq = 0; seq < 6; ++seq) {
    const bool is_base = seq % 2 == 0;
    const std::uint32_t base = seq == 0 ? 0 : (seq - 1) / 2 * 2;
    const auto set =
        frame_set_of({{kSensor, seq, base, is_base ? std::uint8_t{0} : std::uint8_t{1}}});
    send_queue.push_set(set);
    EXPECT_EQ(send_queue.next(), is_base ? set->frames[0].message : nullptr) << seq;
  }
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty());
}

TEST(SendQueue, a_paused_sensor_needs_a_key_frame_once_it_goes_on) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 0, 0}}));
  EXPECT_EQ(drain(send_queue), 1);
  send_queue.set_details({Detail::kPaused});
  send_queue.push_set(frame_set_of({{kSensor, 1, 0}}));
  EXPECT_EQ(drain(send_queue), 0);
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty()) << "nobody needs it now";
  send_queue.set_details({});
  send_queue.push_set(frame_set_of({{kSensor, 2, 1}}));
  EXPECT_EQ(drain(send_queue), 0) << "its reference was left out";
  EXPECT_THAT(send_queue.take_key_needs(), ElementsAre(kSensor));
  send_queue.push_set(frame_set_of({{kSensor, 3, 3}}));
  send_queue.push_set(frame_set_of({{kSensor, 4, 3}}));
  EXPECT_EQ(drain(send_queue), 2);
}

TEST(SendQueue, drops_sets_of_upper_layers_first) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 0, 0}, {kOtherSensor, 0, 0}}));
  EXPECT_EQ(drain(send_queue), 2);
  const auto base = frame_set_of({{kSensor, 1, 0}, {kOtherSensor, 1, 0}});
  send_queue.push_set(base);
  send_queue.push_set(frame_set_of({{kSensor, 2, 1, 1}, {kOtherSensor, 2, 1, 1}}));  // dropped
  const auto next_base = frame_set_of({{kSensor, 3, 1}, {kOtherSensor, 3, 1}});
  send_queue.push_set(next_base);
  EXPECT_EQ(send_queue.next(), base->frames[0].message);
  EXPECT_EQ(send_queue.next(), base->frames[1].message);
  EXPECT_EQ(send_queue.next(), next_base->frames[0].message);
  EXPECT_EQ(drain(send_queue), 1);
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty());
}

// The sensors are out of step: in every set, one of them sends a base frame and the other does not.
TEST(SendQueue, drops_the_upper_layers_of_mixed_sets_first) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 0, 0}, {kOtherSensor, 0, 0}}));
  EXPECT_EQ(drain(send_queue), 2);
  send_queue.push_set(frame_set_of({{kSensor, 1, 0}, {kOtherSensor, 1, 0, 1}}));
  send_queue.push_set(frame_set_of({{kSensor, 2, 1, 1}, {kOtherSensor, 2, 0}}));
  send_queue.push_set(frame_set_of({{kSensor, 3, 1}, {kOtherSensor, 3, 2, 1}}));
  send_queue.push_set(frame_set_of({{kSensor, 4, 3, 1}, {kOtherSensor, 4, 2}}));
  EXPECT_EQ(drain(send_queue), 4) << "four base frames, two sets' worth";
  EXPECT_EQ(send_queue.dropped_sets(), 0U);
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty());
}

TEST(SendQueue, base_frames_are_bounded_too) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 0, 0}, {kOtherSensor, 0, 0}}));
  EXPECT_EQ(drain(send_queue), 2);
  for (std::uint32_t seq = 1; seq <= 100; ++seq) {
    send_queue.push_set(frame_set_of({{kSensor, seq, seq}, {kOtherSensor, seq, 0, 1}}));
  }
  EXPECT_LE(drain(send_queue), 2 * static_cast<int>(wire::kMaxQueuedSets));
}

TEST(SendQueue, a_started_set_is_completed) {
  SendQueue send_queue;
  const auto begun = frame_set_of({{kSensor, 0, 0}, {kOtherSensor, 0, 0}});
  send_queue.push_set(begun);
  EXPECT_EQ(send_queue.next(), begun->frames[0].message);
  for (std::uint32_t i = 1; i < 6; ++i) send_queue.push_set(frame_set_of({{kSensor, i, i}}));
  EXPECT_EQ(send_queue.next(), begun->frames[1].message);
}

TEST(SendQueue, the_first_frame_must_be_a_key_frame) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 8, 7}}));
  EXPECT_EQ(drain(send_queue), 0);
  EXPECT_THAT(send_queue.take_key_needs(), ElementsAre(kSensor));
  send_queue.push_set(frame_set_of({{kSensor, 9, 9}}));
  EXPECT_EQ(drain(send_queue), 1);
}

TEST(SendQueue, after_a_dropped_base_frame_delivery_waits_for_a_key_frame) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 0, 0}}));
  EXPECT_EQ(drain(send_queue), 1);
  constexpr std::uint32_t kLast = SendQueue::kMaxQueuedBaseSets + 1;
  for (std::uint32_t seq = 1; seq <= kLast; ++seq)
    send_queue.push_set(frame_set_of({{kSensor, seq, seq - 1}}));  // set 1 is dropped
  EXPECT_EQ(drain(send_queue), 0);
  EXPECT_THAT(send_queue.take_key_needs(), ElementsAre(kSensor));
  send_queue.push_set(frame_set_of({{kSensor, kLast + 1, kLast}}));
  EXPECT_EQ(drain(send_queue), 0);
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty()) << "a gap is reported once";
  send_queue.push_set(frame_set_of({{kSensor, kLast + 2, kLast + 2}}));
  send_queue.push_set(frame_set_of({{kSensor, kLast + 3, kLast + 2}}));
  EXPECT_EQ(drain(send_queue), 2);
}

TEST(SendQueue, what_builds_on_key_frames_waits_while_these_are_written) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 0, 0}, {kOtherSensor, 0, 0}}));
  EXPECT_NE(send_queue.next(), nullptr);
  for (std::uint32_t seq = 1; seq <= SendQueue::kMaxQueuedBaseSets; ++seq)
    send_queue.push_set(frame_set_of({{kSensor, seq, seq - 1}, {kOtherSensor, seq, seq - 1}}));
  EXPECT_EQ(drain(send_queue), 1 + 2 * static_cast<int>(SendQueue::kMaxQueuedBaseSets));
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty());
}

TEST(SendQueue, what_waits_is_dropped_for_newer_key_frames) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 0, 0}}));
  EXPECT_EQ(drain(send_queue), 1);
  for (std::uint32_t seq = 1; seq <= 4; ++seq)
    send_queue.push_set(frame_set_of({{kSensor, seq, seq - 1}}));
  send_queue.push_set(frame_set_of({{kSensor, 5, 5}}));
  EXPECT_EQ(send_queue.dropped_sets(), 4u) << "none could be decoded without the one before";
  EXPECT_EQ(drain(send_queue), 1);
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty());
}

TEST(SendQueue, a_dropped_upper_layer_frame_breaks_no_chain) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 0, 0}}));
  EXPECT_EQ(drain(send_queue), 1);
  send_queue.push_set(frame_set_of({{kSensor, 1, 0, 1}}));  // dropped
  send_queue.push_set(frame_set_of({{kSensor, 2, 0}}));
  send_queue.push_set(frame_set_of({{kSensor, 3, 2, 1}}));
  EXPECT_EQ(drain(send_queue), 2);
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty());
}

TEST(SendQueue, a_gap_of_one_sensor_leaves_the_others_intact) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 0, 0}, {kOtherSensor, 5, 4}}));
  EXPECT_EQ(drain(send_queue), 1);
  EXPECT_THAT(send_queue.take_key_needs(), ElementsAre(kOtherSensor));
}

TEST(SendQueue, a_restarted_sensor_needs_a_key_frame) {
  SendQueue send_queue;
  send_queue.push_set(frame_set_of({{kSensor, 4, 4}}));
  EXPECT_EQ(drain(send_queue), 1);
  send_queue.forget(kSensor);
  send_queue.push_set(frame_set_of({{kSensor, 5, 4}}));
  EXPECT_EQ(drain(send_queue), 0);
}

TEST(SendQueue, control_messages_are_bounded) {
  SendQueue send_queue;
  for (std::size_t i = 0; i < wire::kMaxQueuedControlMessages; ++i)
    EXPECT_TRUE(send_queue.push_control(some_message()));
  EXPECT_FALSE(send_queue.push_control(some_message()));
}

TEST(SendQueue, a_modeler_gets_key_frames_and_asks_for_none) {
  SendQueue send_queue;
  send_queue.set_details({Detail::kKeyFrames, Detail::kKeyFrames});
  const auto first = frame_set_of({{kSensor, 0, 0}, {kOtherSensor, 4, 3}}, some_message());
  const auto second = frame_set_of({{kSensor, 1, 0}, {kOtherSensor, 5, 3}}, some_message());
  const auto third = frame_set_of({{kSensor, 2, 0}, {kOtherSensor, 6, 6}}, some_message());
  send_queue.push_set(first);
  EXPECT_EQ(send_queue.next(), first->frames[0].message);
  EXPECT_EQ(send_queue.next(), first->end);
  send_queue.push_set(second);
  EXPECT_EQ(send_queue.next(), nullptr);
  send_queue.push_set(third);
  EXPECT_EQ(send_queue.next(), third->frames[1].message);
  EXPECT_EQ(send_queue.next(), nullptr);
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty());
}

}  // namespace
}  // namespace roomcast::hub
