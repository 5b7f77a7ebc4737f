// SPDX-License-Identifier: Apache-2.0
// The functions of roomcast.h about people's voices.
#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "roomcast/capi/c_border.h"
#include "roomcast/capi/roomcast.h"
#include "roomcast/capi/viewer.h"
#include "roomcast/client/room/speaker.h"
#include "roomcast/client/voices/speak.h"
#include "roomcast/wire/audio_header.h"
#include "roomcast/wire/limits.h"

namespace {

using namespace roomcast;

static_assert(ROOMCAST_VOICE_RATE_HZ == voice::kVoiceRate_hz);
static_assert(ROOMCAST_VOICE_SAMPLES == voice::kPacketSamples);
static_assert(ROOMCAST_VOICE_SENSOR == wire::kSensorSpeakers);
static_assert(ROOMCAST_VOICE_MAX_BYTES == wire::kMaxAudioPayloadBytes);

std::optional<client::VoiceListener::Heard> next_heard(roomcast_viewer& viewer, int timeout_ms) {
  {
    const std::lock_guard lock(viewer.hears);
    if (auto heard = viewer.listener.next()) return heard;
  }
  auto packet = viewer.subscriber->next_voice(std::chrono::milliseconds(std::max(timeout_ms, 0)));
  const std::lock_guard lock(viewer.hears);
  if (packet) viewer.listener.take(*std::move(packet));
  return viewer.listener.next();
}

void locate(const client::RoomSnapshot& room, roomcast_voice& voice) {
  const auto world_from_head = client::world_from_speaker(room, ViewerId{voice.speaker});
  if (!world_from_head) return;
  voice.has_head = 1;
  std::ranges::copy(row_major_from_transform(*world_from_head), voice.world_from_head);
}

void fill_voice(const roomcast_viewer& viewer, const client::VoiceListener::Heard& heard,
                roomcast_voice& out) {
  roomcast_voice voice = capi::known_part(&out);  // the caller's pointers
  const client::HeardPacket& packet = heard.packet;
  if (voice.samples != nullptr) std::ranges::copy(heard.samples, voice.samples);
  if (voice.opus != nullptr) std::ranges::copy(packet.opus, voice.opus);
  voice.opus_bytes = packet.opus.size();
  voice.speaker = packet.speaker.value;
  voice.seq = packet.seq;
  voice.ends = packet.ends ? 1 : 0;
  voice.capture_ns = packet.capture_time.time_since_epoch().count();
  voice.has_head = 0;
  std::ranges::fill(voice.world_from_head, 0);
  locate(*viewer.subscriber->snapshot(), voice);
  capi::copy_known_part(voice, out);
}

}  // namespace

extern "C" {

int roomcast_next_voice(roomcast_viewer* viewer, int timeout_ms, roomcast_voice* voice) {
  return capi::guarded(0, nullptr, 0, [&] {
    const auto heard = next_heard(*viewer, timeout_ms);
    if (!heard) return 0;
    fill_voice(*viewer, *heard, *voice);
    return 1;
  });
}

int roomcast_may_speak(roomcast_viewer* viewer, char* error, size_t error_size) {
  return capi::guarded(0, error, error_size, [&] {
    const Status may = client::check_may_speak(viewer->subscriber->snapshot()->rights);
    if (!may) capi::say(may.error().message, error, error_size);
    return may ? 1 : 0;
  });
}

int roomcast_speak(roomcast_viewer* viewer, const float* samples, size_t count, char* error,
                   size_t error_size) {
  return capi::guarded(0, error, error_size, [&] {
    const std::lock_guard lock(viewer->speaks);
    const Status said =
        client::speak(*viewer->subscriber, viewer->spoken,
                      std::span(samples, samples == nullptr ? 0 : count), SteadyClock().now());
    if (!said) capi::say(said.error().message, error, error_size);
    return said ? 1 : 0;
  });
}

void roomcast_pause_speaking(roomcast_viewer* viewer) {
  capi::guarded(0, nullptr, 0, [&] {
    const std::lock_guard lock(viewer->speaks);
    client::pause_speaking(*viewer->subscriber, viewer->spoken);
    return 0;
  });
}

}  // extern "C"
