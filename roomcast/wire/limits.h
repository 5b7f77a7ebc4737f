// SPDX-License-Identifier: Apache-2.0
// All limits of roomcast.v1. The table for people is docs/spec/wire.md §4; limits_test.cpp and the
// tests of the enforcing code check them.
#pragma once

#include <chrono>
#include <cstddef>

namespace roomcast::wire {

// Messages.
inline constexpr std::size_t kMaxFrameBytes = 2u << 20;               // header and payload
inline constexpr std::size_t kMaxControlFromClientBytes = 16u << 10;  // with the 4-byte preamble
inline constexpr std::size_t kMaxControlFromHubBytes = 256u << 10;
inline constexpr std::size_t kMaxBundleBytes = 2u << 20;    // a control message with a bundle
inline constexpr std::size_t kMaxAudioBytes = 1400;         // header and payload
inline constexpr std::size_t kMaxAudioPayloadBytes = 1275;  // one frame of Opus, RFC 6716 §3.2.1

// Connections.
inline constexpr std::chrono::seconds kJoinDeadline{5};
inline constexpr std::size_t kMaxUnjoinedConnections = 256;
inline constexpr std::size_t kMaxSensors = 32;
inline constexpr std::size_t kMaxViewers = 2048;
inline constexpr std::size_t kMaxAligners = 4;
inline constexpr std::size_t kMaxModelers = 2;
inline constexpr std::size_t kMaxQueuedControlMessages = 64;  // per connection

// Sending limits of one connection: sustained rates, and bursts, which follow a network stall.
struct SendingLimits {
  double messages_per_s, messages_at_once;
  double bytes_per_s, bytes_at_once;
};
inline constexpr SendingLimits kMaxFromSensor{1000, 2000, 64e6, 128e6};  // frames, at most 240 Hz
inline constexpr SendingLimits kMaxFromViewer{300, 1200, 256e3, 1e6};  // poses; also before joining
inline constexpr SendingLimits kMaxFromHub{300, 1200, 1e6, 4e6};       // presence of its viewers
inline constexpr SendingLimits kMaxFromSpeaker{60, 150, 16e3, 64e3};   // audio packets, 50 a second
inline constexpr SendingLimits kMaxFromAligner{100, 400, 1e6, 4e6};    // placements

// Contents of messages.
inline constexpr std::size_t kMaxNameBytes = 64;
inline constexpr std::size_t kMaxRecordingNameBytes = 120;
inline constexpr std::size_t kMaxNoteBytes = 300;
inline constexpr std::size_t kMaxTokenBytes = 1024;
inline constexpr int kMaxOtherHubs = 16;
inline constexpr std::size_t kMaxUrlBytes = 256;
inline constexpr int kMaxPeopleHere = 64;                // that one hub reports to another
inline constexpr std::size_t kMaxPeopleElsewhere = 128;  // in a room
inline constexpr unsigned kMaxHubsAway = 4;
inline constexpr int kMaxRevokedTokens = 256;                      // per message
inline constexpr float kMaxNoiseRatio = 1000;                      // of a sensor's health
inline constexpr double kMinDepthScale = 0.5, kMaxDepthScale = 2;  // factors on readings
inline constexpr double kMaxTargetMbit = 1000;                     // that a sensor is asked for
inline constexpr int kMaxSightings = 64;                           // of each kind, per message
inline constexpr unsigned kMaxImageSide = 8192;
inline constexpr unsigned kMinDepthSide = 16;
inline constexpr unsigned kMaxDepthSide = 4096;
inline constexpr double kMaxFps = 240;
inline constexpr int kMaxPosesPerSecond = 60;
inline constexpr int kMaxPosesPerMessage = 512;
inline constexpr double kMaxPosition_m = 10'000;
inline constexpr unsigned kMaxLayer = 7;
inline constexpr unsigned kMaxCoarseSide = 64;  // cells of CoarseDepth in a row or column
inline constexpr float kMaxViewHalfAngle_rad = 3.14159265F;  // sees all around

// Marks.
inline constexpr int kMaxMarkPoints = 512;  // of one sketch
inline constexpr std::size_t kMaxMarkTextBytes = 280;
inline constexpr int kMaxMarks = 500;             // in a room
inline constexpr int kMaxMarksOfAuthor = 100;     // of these
inline constexpr int kMaxPointsOfMarks = 50'000;  // in a room
inline constexpr double kMaxMarksPerSecond = 5;   // from one viewer, sustained; removals count, too
inline constexpr double kMaxMarksAtOnce = 25;     // and these at once
inline constexpr std::size_t kMaxAuthorKeyBytes = 64;

// Frame sets.
inline constexpr std::size_t kMaxQueuedSets = 2;  // per viewer, no byte of them written yet
inline constexpr std::chrono::milliseconds kSetDeadline{50};
inline constexpr std::chrono::seconds kSensorSilent{1};
inline constexpr std::chrono::seconds kMaxCaptureAhead{1};

// Audio.
inline constexpr std::size_t kMaxSpeakersHeard = 8;        // by one listener at a time
inline constexpr std::size_t kMaxQueuedAudioPackets = 10;  // per listener and speaker: 200 ms

// Rates.
inline constexpr std::chrono::milliseconds kKeyRequestInterval{500};  // per sensor
inline constexpr std::chrono::milliseconds kPoseInterval{50};         // hub to viewers, or longer:
inline constexpr std::chrono::milliseconds kIntervalPerPose{5};   // for each pose that has changed
inline constexpr std::chrono::milliseconds kRosterInterval{100};  // if only viewers changed
inline constexpr std::chrono::milliseconds kVoicesInterval{200};  // who speaks

}  // namespace roomcast::wire
