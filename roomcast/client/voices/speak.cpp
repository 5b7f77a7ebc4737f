// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/voices/speak.h"

#include <utility>

namespace roomcast::client {
namespace {

void send(Subscriber& room, SpokenPacket packet) {
  room.say(std::move(packet.opus), packet.ends, packet.first_sample);
}

}  // namespace

Status speak(Subscriber& room, SpokenVoice& voice, std::span<const float> samples, HostTime now) {
  const auto snapshot = room.snapshot();
  if (snapshot->connected) {
    if (Status may = check_may_speak(snapshot->rights); !may) return may;
  }
  auto packets = voice.say(samples, now);
  if (!packets) return packets.error();
  for (SpokenPacket& packet : *packets) send(room, std::move(packet));
  return {};
}

void pause_speaking(Subscriber& room, SpokenVoice& voice) {
  if (auto last = voice.pause()) send(room, *std::move(last));
}

}  // namespace roomcast::client
