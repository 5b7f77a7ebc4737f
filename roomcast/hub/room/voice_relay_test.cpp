// SPDX-License-Identifier: Apache-2.0
#include "roomcast/hub/room/voice_relay.h"

#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/wire/limits.h"

namespace roomcast::hub {
namespace {

using namespace std::chrono_literals;
using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::UnorderedElementsAre;

RoomTime moment(nanoseconds since_start) {
  return RoomTime(1h + since_start);
}

/// Viewers along a line; viewer n listens at connection 100 + n.
class VoiceRelayTest : public testing::Test {
 protected:
  void listen(std::uint32_t viewer) { relay.add_listener(ViewerId{viewer}, ear(viewer)); }
  static ConnectionId ear(std::uint32_t viewer) { return ConnectionId{100 + viewer}; }
  void stand(std::uint32_t viewer, float x_m) { heads[ViewerId{viewer}] = {x_m, 0, 0}; }

  std::vector<ConnectionId> speak(std::uint32_t viewer, nanoseconds now, bool ends = false) {
    return relay.receivers(ViewerId{viewer}, ends, moment(now), [this](ViewerId id) {
      const auto head = heads.find(id);
      return head == heads.end() ? std::nullopt : std::optional(head->second);
    });
  }
  /// All of 1 to `count` speak, the last one after all are known.
  void all_speak(std::uint32_t count, nanoseconds now) {
    for (std::uint32_t viewer = 1; viewer <= count; ++viewer) (void)speak(viewer, now);
  }

  VoiceRelay relay;
  std::map<ViewerId, Eigen::Vector3f> heads;
};

TEST_F(VoiceRelayTest, everybody_but_the_speaker_hears_it) {
  listen(1);
  listen(2);
  listen(3);
  EXPECT_THAT(speak(1, 0s), UnorderedElementsAre(ear(2), ear(3)));
  EXPECT_THAT(speak(9, 0s), UnorderedElementsAre(ear(1), ear(2), ear(3)));
}

TEST_F(VoiceRelayTest, beyond_eight_speakers_the_nearest_are_heard) {
  listen(50);
  stand(50, 0);
  for (std::uint32_t viewer = 1; viewer <= 12; ++viewer) stand(viewer, static_cast<float>(viewer));
  all_speak(12, 0s);
  all_speak(12, 200ms);  // the choice is at most 100 ms old
  for (std::uint32_t viewer = 1; viewer <= 12; ++viewer) {
    EXPECT_EQ(speak(viewer, 220ms).size(), viewer <= wire::kMaxSpeakersHeard ? 1U : 0U) << viewer;
  }
}

TEST_F(VoiceRelayTest, a_recorder_gets_all_speakers) {
  relay.add_listener(ViewerId{50}, ear(50), Hearing::kAll);
  all_speak(12, 0s);
  for (std::uint32_t viewer = 1; viewer <= 12; ++viewer)
    EXPECT_THAT(speak(viewer, 200ms), ElementsAre(ear(50))) << viewer;
}

TEST_F(VoiceRelayTest, one_of_nine_speakers_hears_the_eight_others) {
  for (std::uint32_t viewer = 1; viewer <= 9; ++viewer) listen(viewer);
  all_speak(9, 0s);
  all_speak(9, 200ms);
  for (std::uint32_t viewer = 1; viewer <= 9; ++viewer)
    EXPECT_EQ(speak(viewer, 220ms).size(), 8U) << viewer;
}

TEST_F(VoiceRelayTest, who_comes_near_is_heard_within_half_a_second) {
  listen(50);
  stand(50, 0);
  for (std::uint32_t viewer = 1; viewer <= 9; ++viewer) stand(viewer, static_cast<float>(viewer));
  all_speak(9, 0s);
  all_speak(9, 200ms);
  EXPECT_THAT(speak(9, 220ms), IsEmpty());
  stand(9, 0.5F);
  EXPECT_THAT(speak(9, 240ms), IsEmpty());
  all_speak(9, 720ms);
  EXPECT_THAT(speak(9, 740ms), ElementsAre(ear(50)));
  EXPECT_THAT(speak(8, 740ms), IsEmpty());
}

TEST_F(VoiceRelayTest, without_a_position_those_who_began_last_are_heard) {
  listen(50);  // it has no head
  for (std::uint32_t viewer = 1; viewer <= 9; ++viewer) {
    stand(viewer, 1);
    (void)speak(viewer, viewer * 10ms);
  }
  all_speak(9, 300ms);
  EXPECT_THAT(speak(1, 320ms), IsEmpty());
  EXPECT_THAT(speak(9, 320ms), ElementsAre(ear(50)));
}

TEST_F(VoiceRelayTest, a_speaker_without_a_position_comes_after_those_with_one) {
  listen(50);
  stand(50, 0);
  for (std::uint32_t viewer = 1; viewer <= 8; ++viewer) stand(viewer, 1000);
  (void)speak(9, 0s);
  all_speak(9, 10ms);
  all_speak(9, 200ms);
  EXPECT_THAT(speak(9, 220ms), IsEmpty());
}

TEST_F(VoiceRelayTest, a_muted_speaker_is_heard_by_nobody) {
  listen(1);
  (void)speak(2, 0s);
  relay.set_muted(ViewerId{2}, true);
  EXPECT_THAT(speak(2, 20ms), IsEmpty());
  EXPECT_FALSE(relay.is_speaking(ViewerId{2}));
  const auto told = relay.take(moment(20ms));
  ASSERT_TRUE(told);
  EXPECT_THAT(told->voices().muted(), ElementsAre(2));
  EXPECT_THAT(told->voices().speaking(), IsEmpty());
  relay.set_muted(ViewerId{2}, false);
  EXPECT_THAT(speak(2, 40ms), ElementsAre(ear(1)));
}

TEST_F(VoiceRelayTest, listeners_are_told_who_speaks_and_who_has_ended) {
  listen(1);
  (void)speak(2, 0s);
  auto told = relay.take(moment(0s));
  ASSERT_TRUE(told);
  EXPECT_THAT(told->voices().speaking(), ElementsAre(2));
  (void)speak(2, 20ms, true);
  EXPECT_FALSE(relay.take(moment(20ms))) << "at most five times a second";
  EXPECT_EQ(relay.next(), moment(200ms));
  told = relay.take(moment(200ms));
  ASSERT_TRUE(told);
  EXPECT_THAT(told->voices().speaking(), IsEmpty());
  EXPECT_FALSE(relay.next());
}

TEST_F(VoiceRelayTest, a_speaker_that_falls_silent_has_paused) {
  (void)speak(2, 0s);
  EXPECT_TRUE(relay.take(moment(0s)));
  EXPECT_EQ(relay.next(), moment(500ms));
  EXPECT_FALSE(relay.take(moment(499ms)));
  EXPECT_TRUE(relay.is_speaking(ViewerId{2}));
  const auto told = relay.take(moment(500ms));
  ASSERT_TRUE(told);
  EXPECT_THAT(told->voices().speaking(), IsEmpty());
}

TEST_F(VoiceRelayTest, who_has_left_neither_hears_nor_speaks_nor_is_muted) {
  listen(1);
  listen(3);
  (void)speak(2, 0s);
  relay.set_muted(ViewerId{3}, true);
  relay.forget(ViewerId{3});
  relay.forget(ViewerId{2});
  EXPECT_EQ(relay.speaker_count(), 0U);
  EXPECT_FALSE(relay.is_muted(ViewerId{3}));
  EXPECT_THAT(speak(4, 20ms), Not(Contains(ear(3))));
  EXPECT_THAT(relay.listeners(), ElementsAre(ear(1)));
}

}  // namespace
}  // namespace roomcast::hub
