// SPDX-License-Identifier: Apache-2.0
// roomcast_viewer, which the functions about frames, people, marks, voices and sensors share.
// Threading: thread-safe by its mutexes, of which at most one is held at a time.
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>

#include "roomcast/capi/room_points.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/client/voices/spoken_voice.h"
#include "roomcast/client/voices/voice_listener.h"
#include "roomcast/recording/recorder/unix_clock.h"

struct roomcast_viewer {
  std::unique_ptr<roomcast::client::Subscriber> subscriber;
  const roomcast::recording::UnixClock unix_clock;

  std::mutex mutex;  // of what belongs to frames
  roomcast::SetId last_set{};
  std::uint64_t last_revision = 0;
  roomcast::capi::SensorRays rays;

  std::mutex asks;  // one request to the hub at a time
  std::mutex hears;
  roomcast::client::VoiceListener listener;
  std::mutex speaks;
  roomcast::client::SpokenVoice spoken;
};
