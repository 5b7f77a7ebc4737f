// SPDX-License-Identifier: Apache-2.0
// The table of docs/spec/wire.md §4 repeated, so that a limit is changed on purpose only: a changed
// limit changes the protocol.
#include "roomcast/wire/limits.h"

#include <gtest/gtest.h>

namespace roomcast::wire {
namespace {

TEST(Limits, are_those_of_the_spec) {
  using namespace std::chrono_literals;
  EXPECT_EQ(kMaxFrameBytes, 2'097'152u);
  EXPECT_EQ(kMaxControlFromClientBytes, 16'384u);
  EXPECT_EQ(kMaxControlFromHubBytes, 262'144u);
  EXPECT_EQ(kMaxBundleBytes, 2'097'152u);
  EXPECT_EQ(kMaxAudioBytes, 1400u);
  EXPECT_EQ(kMaxAudioPayloadBytes, 1275u);
  EXPECT_EQ(kMaxNoteBytes, 300u);
  EXPECT_EQ(kMaxTokenBytes, 1024u);
  EXPECT_EQ(kMaxOtherHubs, 16);
  EXPECT_EQ(kMaxUrlBytes, 256u);
  EXPECT_EQ(kMaxSightings, 64);
  EXPECT_EQ(kMaxPeopleHere, 64);
  EXPECT_EQ(kMaxPeopleElsewhere, 128u);
  EXPECT_EQ(kMaxHubsAway, 4u);
  EXPECT_EQ(kMaxRevokedTokens, 256);
  EXPECT_EQ(kMaxNoiseRatio, 1000);
  EXPECT_EQ(kMaxAligners, 4u);
  EXPECT_EQ(kMaxModelers, 2u);
  EXPECT_EQ(kJoinDeadline, 5s);
  EXPECT_EQ(kMaxUnjoinedConnections, 256u);
  EXPECT_EQ(kMaxSensors, 32u);
  EXPECT_EQ(kMaxViewers, 2048u);
  EXPECT_EQ(kMaxPosesPerMessage, 512);
  EXPECT_EQ(kMaxQueuedControlMessages, 64u);
  EXPECT_EQ(kMaxNameBytes, 64u);
  EXPECT_EQ(kMaxImageSide, 8192u);
  EXPECT_EQ(kMinDepthSide, 16u);
  EXPECT_EQ(kMaxDepthSide, 4096u);
  EXPECT_EQ(kMaxFps, 240);
  EXPECT_EQ(kMaxPosesPerSecond, 60);
  EXPECT_EQ(kMaxMarkPoints, 512);
  EXPECT_EQ(kMaxMarkTextBytes, 280u);
  EXPECT_EQ(kMaxMarks, 500);
  EXPECT_EQ(kMaxMarksOfAuthor, 100);
  EXPECT_EQ(kMaxPointsOfMarks, 50'000);
  EXPECT_EQ(kMaxMarksPerSecond, 5);
  EXPECT_EQ(kMaxMarksAtOnce, 25);
  EXPECT_EQ(kMaxAuthorKeyBytes, 64u);
  EXPECT_EQ(kMaxQueuedSets, 2u);
  EXPECT_EQ(kMaxSpeakersHeard, 8u);
  EXPECT_EQ(kMaxQueuedAudioPackets, 10u);
  EXPECT_EQ(kSetDeadline, 50ms);
  EXPECT_EQ(kSensorSilent, 1s);
  EXPECT_EQ(kMaxCaptureAhead, 1s);
  EXPECT_EQ(kKeyRequestInterval, 500ms);
  EXPECT_EQ(kPoseInterval, 50ms);
  EXPECT_EQ(kIntervalPerPose, 5ms);
  EXPECT_EQ(kRosterInterval, 100ms);
  EXPECT_EQ(kVoicesInterval, 200ms);
}

void expect_limits(const SendingLimits& limits, double messages_per_s, double messages_at_once,
                   double bytes_per_s, double bytes_at_once) {
  EXPECT_EQ(limits.messages_per_s, messages_per_s);
  EXPECT_EQ(limits.messages_at_once, messages_at_once);
  EXPECT_EQ(limits.bytes_per_s, bytes_per_s);
  EXPECT_EQ(limits.bytes_at_once, bytes_at_once);
}

TEST(Limits, per_role_are_those_of_the_spec) {
  expect_limits(kMaxFromSensor, 1000, 2000, 64e6, 128e6);
  expect_limits(kMaxFromViewer, 300, 1200, 256e3, 1e6);
  expect_limits(kMaxFromHub, 300, 1200, 1e6, 4e6);
  expect_limits(kMaxFromSpeaker, 60, 150, 16e3, 64e3);
  expect_limits(kMaxFromAligner, 100, 400, 1e6, 4e6);
}

}  // namespace
}  // namespace roomcast::wire
