// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/frame_sequence.h"

#include <gtest/gtest.h>

namespace roomcast::client {
namespace {

constexpr codec::EncodedFrameInfo kKeyFrame{.key = true, .layer = 0},
    kBaseFrame{.key = false, .layer = 0}, kDroppableFrame{.key = false, .layer = 1};

TEST(FrameSequence, a_session_begins_with_a_key_frame) {
  FrameSequence sequence;
  sequence.enter(1);
  EXPECT_FALSE(sequence.next(kBaseFrame));
  EXPECT_EQ(sequence.next(kKeyFrame)->seq, 0U);
}

TEST(FrameSequence, frames_build_on_the_last_one_that_is_not_droppable) {
  FrameSequence sequence;
  sequence.enter(1);
  sequence.sent(*sequence.next(kKeyFrame));
  sequence.sent(*sequence.next(kDroppableFrame));
  EXPECT_EQ(sequence.next(kBaseFrame)->seq, 2U);
  EXPECT_EQ(sequence.next(kBaseFrame)->base_seq, 0U);
  sequence.sent(*sequence.next(kBaseFrame));
  EXPECT_EQ(sequence.next(kBaseFrame)->base_seq, 2U);
}

TEST(FrameSequence, a_frame_that_is_not_sent_uses_no_number) {
  FrameSequence sequence;
  sequence.enter(1);
  (void)sequence.next(kKeyFrame);
  EXPECT_EQ(sequence.next(kKeyFrame)->seq, 0U);
}

TEST(FrameSequence, skipped_frames_are_counted_once_a_frame_was_sent) {
  FrameSequence sequence;
  sequence.enter(1);
  sequence.skip(1);
  EXPECT_EQ(sequence.next(kKeyFrame)->seq, 0U);
  sequence.sent(*sequence.next(kKeyFrame));
  sequence.skip(2);
  EXPECT_EQ(sequence.next(kBaseFrame)->seq, 1U) << "a frame of another session";
  sequence.skip(1);
  EXPECT_EQ(sequence.next(kBaseFrame)->seq, 2U);
}

TEST(FrameSequence, another_session_begins_anew) {
  FrameSequence sequence;
  sequence.enter(1);
  sequence.sent(*sequence.next(kKeyFrame));
  sequence.enter(1);
  EXPECT_EQ(sequence.next(kKeyFrame)->seq, 1U);
  sequence.enter(2);
  EXPECT_FALSE(sequence.next(kBaseFrame));
  EXPECT_EQ(sequence.next(kKeyFrame)->seq, 0U);
}

}  // namespace
}  // namespace roomcast::client
