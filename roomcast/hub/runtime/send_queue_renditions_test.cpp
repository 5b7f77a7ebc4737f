// SPDX-License-Identifier: Apache-2.0
// Which rendition of a sensor a SendQueue gives to a slow line.
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/hub/runtime/send_queue.h"
#include "roomcast/hub/runtime/send_queue_fixture.h"

namespace roomcast::hub {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A room with one sensor that sends both renditions, each a key frame at first, to a viewer.
class SlowLine : public testing::Test {
 protected:
  SlowLine() { send_queue.allow_small(); }

  FrameSetPtr offer(bool key = false) {
    const std::uint32_t base = key || seq == 0 ? seq : seq - 1;
    auto set = frame_set_of({{kSensor, seq, base, 0, true}, {kSensor, seq, base}}, some_message());
    ++seq;
    send_queue.push_set(set);
    return set;
  }

  /// Offers sets that are not read until small needs come.
  SmallNeeds clog() {
    for (int i = 0; i < 3 * RenditionChoice::kWindow; ++i) {
      offer();
      if (auto needs = send_queue.take_small_needs()) return *needs;
    }
    return {};
  }

  SendQueue send_queue;
  std::uint32_t seq = 0;
};

TEST_F(SlowLine, without_loss_the_full_rendition_comes) {
  for (int i = 0; i < 100; ++i) {
    const auto set = offer();
    EXPECT_EQ(send_queue.next(), set->frames[1].message);
    EXPECT_EQ(send_queue.next(), nullptr);
  }
  EXPECT_FALSE(send_queue.take_small_needs());
}

TEST_F(SlowLine, the_small_rendition_comes_from_its_next_key_frame_on) {
  EXPECT_THAT(clog().wanted, ElementsAre(kSensor));
  drain(send_queue);
  EXPECT_THAT(send_queue.take_key_needs(), IsEmpty()) << "the small one is about to come";
  const auto needs = send_queue.take_small_needs();
  ASSERT_TRUE(needs.has_value());
  EXPECT_THAT(needs->keys, ElementsAre(kSensor));
  auto set = offer(true);
  EXPECT_EQ(send_queue.next(), set->frames[0].message);
  EXPECT_EQ(send_queue.next(), set->end) << "the last frame is left out";
  set = offer();
  EXPECT_EQ(send_queue.next(), set->frames[0].message);
  EXPECT_EQ(send_queue.next(), set->end);
  EXPECT_EQ(send_queue.next(), nullptr);
}

TEST_F(SlowLine, the_full_rendition_comes_again_once_the_line_is_good) {
  clog();
  offer(true);
  drain(send_queue);
  std::optional<SmallNeeds> needs;
  for (int i = 0; i < 2000 && !(needs && needs->wanted.empty()); ++i) {
    offer();
    drain(send_queue);
    if (auto news = send_queue.take_small_needs()) needs = news;
  }
  ASSERT_TRUE(needs.has_value());
  EXPECT_THAT(needs->wanted, IsEmpty());
  auto set = offer();
  EXPECT_EQ(send_queue.next(), set->frames[0].message) << "until a key frame of the full one comes";
  drain(send_queue);
  EXPECT_THAT(send_queue.take_key_needs(), ElementsAre(kSensor));
  set = offer(true);
  EXPECT_EQ(send_queue.next(), set->frames[0].message);
  EXPECT_EQ(send_queue.next(), set->frames[1].message);
  drain(send_queue);
  set = offer();
  EXPECT_EQ(send_queue.next(), set->frames[1].message);
}

TEST_F(SlowLine, sets_without_a_small_frame_are_dropped_first_and_the_rest_goes_on) {
  clog();
  offer(true);
  drain(send_queue);
  const auto begun = offer();
  const auto key = frame_set_of({{kOtherSensor, 0, 0}}, some_message());
  for (std::uint32_t i = 0; i < 10; ++i)
    send_queue.push_set(frame_set_of({{kSensor, seq + i, seq + i - 1}}, some_message()));
  EXPECT_EQ(send_queue.next(), begun->frames[0].message);
  send_queue.push_set(key);
  EXPECT_EQ(send_queue.next(), begun->end);
  EXPECT_EQ(send_queue.next(), key->frames[0].message);
}

TEST_F(SlowLine, a_sensor_without_a_small_rendition_goes_on_with_its_next_key_frame) {
  for (std::uint32_t i = 0; i < 100; ++i)
    send_queue.push_set(frame_set_of({{kSensor, i, i == 0 ? 0 : i - 1}}));
  drain(send_queue);
  EXPECT_THAT(send_queue.take_key_needs(), ElementsAre(kSensor));
  send_queue.push_set(frame_set_of({{kSensor, 200, 200}}));
  EXPECT_EQ(drain(send_queue), 1);
}

TEST_F(SlowLine, who_records_gets_the_full_rendition_only) {
  SendQueue recorder;
  for (std::uint32_t i = 0; i < 100; ++i)
    recorder.push_set(frame_set_of({{kSensor, i, i, 0, true}, {kSensor, i, i}}, some_message()));
  EXPECT_FALSE(recorder.take_small_needs());
  const auto set = frame_set_of({{kSensor, 100, 100, 0, true}, {kSensor, 100, 100}});
  drain(recorder);
  recorder.push_set(set);
  EXPECT_EQ(recorder.next(), set->frames[1].message);
  EXPECT_EQ(recorder.next(), nullptr);
}

TEST_F(SlowLine, of_a_sensor_that_is_held_back_key_frames_come_when_the_line_is_idle) {
  constexpr SensorId kNeeded{0}, kLess{1};
  send_queue.set_details({Detail::kAll, Detail::kBaseOnly});
  std::uint32_t number = 0;
  const auto offer_both = [&](bool less_is_key) {
    const std::uint32_t base = number == 0 ? 0 : number - 1;
    send_queue.push_set(frame_set_of({{kNeeded, number, number, 0, true},
                                      {kNeeded, number, number},
                                      {kLess, number, less_is_key ? number : base, 0, true},
                                      {kLess, number, number}},
                                     some_message()));
    ++number;
  };
  SmallNeeds needs;
  for (int i = 0; i < 500 && needs.held_back.empty(); ++i) {
    offer_both(i == 0);
    if (i % 4 == 0) (void)send_queue.next();
    if (auto news = send_queue.take_small_needs()) needs = *news;
  }
  EXPECT_THAT(needs.held_back, ElementsAre(kLess));
  drain(send_queue);
  (void)send_queue.take_small_needs();
  int keys = 0, messages = 0;
  for (int i = 0; i < 2 * SendQueue::kSetsPerHeldKey; ++i) {
    const auto news = send_queue.take_small_needs();
    const bool is_asked = news && !news->keys.empty();
    if (news && news->held_back.empty()) break;  // it is tried again
    if (is_asked) {
      EXPECT_THAT(news->keys, ElementsAre(kLess));
      ++keys;
    }
    offer_both(is_asked);
    const int sent = drain(send_queue);
    EXPECT_EQ(sent, is_asked ? 3 : 2) << "with the end of the set";
    messages += sent;
  }
  EXPECT_GE(keys, 1);
  EXPECT_GT(messages, SendQueue::kSetsPerHeldKey);
}

TEST_F(SlowLine, a_small_key_frame_that_is_dropped_is_asked_for_again) {
  clog();
  drain(send_queue);
  auto needs = send_queue.take_small_needs();
  ASSERT_TRUE(needs.has_value());
  ASSERT_THAT(needs->keys, ElementsAre(kSensor));
  const auto begun = offer();              // the line is busy with it
  for (std::uint32_t i = 0; i < 4; ++i) {  // key frames of another one wait, too
    send_queue.push_set(frame_set_of({{kOtherSensor, i, i}}));
    if (i == 0) offer(true);
  }
  for (int i = 0; i < 20; ++i) offer();
  drain(send_queue);
  needs = send_queue.take_small_needs();
  ASSERT_TRUE(needs.has_value());
  EXPECT_THAT(needs->keys, ElementsAre(kSensor));
}

TEST_F(SlowLine, what_the_viewer_turns_to_comes_whole_first) {
  const auto both = [this] {
    ++seq;
    return frame_set_of({{kSensor, seq, seq}, {kOtherSensor, seq, seq}});
  };
  send_queue.set_details({Detail::kAll, Detail::kBaseOnly});
  std::optional<SmallNeeds> needs;
  for (int i = 0; i < 64 && !needs; ++i) {
    send_queue.push_set(both());
    for (int frame = 0; frame < 2 && i % 3 != 0; ++frame) (void)send_queue.next();
    needs = send_queue.take_small_needs();
  }
  ASSERT_TRUE(needs.has_value());
  EXPECT_THAT(needs->wanted, ElementsAre(kOtherSensor));
  send_queue.set_details({Detail::kBaseOnly, Detail::kAll});
  needs = send_queue.take_small_needs();
  ASSERT_TRUE(needs.has_value());
  EXPECT_THAT(needs->wanted, ElementsAre(kSensor));
}

TEST_F(SlowLine, what_the_viewer_needs_less_comes_small_first) {
  send_queue.set_details({Detail::kBaseOnly, Detail::kAll, Detail::kBaseOnly, Detail::kAll});
  std::optional<SmallNeeds> needs;
  for (std::uint32_t i = 0; i < 64 && !needs; ++i) {
    send_queue.push_set(frame_set_of(
        {{SensorId{0}, i, i}, {SensorId{1}, i, i}, {SensorId{2}, i, i}, {SensorId{3}, i, i}}));
    for (int frame = 0; frame < 4 && i % 3 != 0; ++frame) (void)send_queue.next();
    needs = send_queue.take_small_needs();
  }
  ASSERT_TRUE(needs.has_value());
  EXPECT_THAT(needs->wanted, testing::UnorderedElementsAre(SensorId{0}, SensorId{2}));
}

}  // namespace
}  // namespace roomcast::hub
