// SPDX-License-Identifier: Apache-2.0
#include "roomcast/sensor/room_microphone.h"

#include <random>
#include <utility>

#include "roomcast/core/backoff.h"
#include "roomcast/core/interruptible_wait.h"

namespace roomcast::sensor {

RoomMicrophone::RoomMicrophone(std::unique_ptr<sound::Microphone> microphone,
                               sound::OpenMicrophone reopens, client::Publisher& publisher,
                               LogSink log)
    : microphone_(std::move(microphone)),
      reopens_(std::move(reopens)),
      publisher_(publisher),
      log_(std::move(log)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

RoomMicrophone::~RoomMicrophone() {
  thread_.request_stop();
  thread_.join();
}

RoomMicrophoneStats RoomMicrophone::stats() const {
  const std::lock_guard lock(mutex_);
  return stats_;
}

void RoomMicrophone::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const auto block = microphone_->next(stop);
    if (!block) {
      pause();
      if (log_) log_(LogLevel::kWarning, block.error().message + "; looking for it");
      if (!look_for_device(stop)) return;
    } else if (*block) {
      take(**block);
    } else {
      change([](RoomMicrophoneStats& stats) { stats.has_ended = true; });
      break;
    }
  }
  pause();
}

/// False: `stop` was requested.
bool RoomMicrophone::look_for_device(const std::stop_token& stop) {
  change([](RoomMicrophoneStats& stats) { stats.is_connected = false, stats.loudness = 0; });
  microphone_.reset();  // the device may be opened by one at a time
  Backoff backoff(std::random_device{}());
  while (wait_for(backoff.next(), stop)) {
    auto again = reopens_();
    if (!again) continue;
    microphone_ = *std::move(again);
    change([](RoomMicrophoneStats& stats) { stats.is_connected = true; });
    if (log_) log_(LogLevel::kInfo, "the microphone is back");
    return true;
  }
  return false;
}

void RoomMicrophone::take(const sound::Microphone::Block& block) {
  const bool is_permitted = publisher_.may_speak();
  tell_of_permission(is_permitted);
  change([&](RoomMicrophoneStats& stats) {
    stats.is_permitted = is_permitted;
    stats.loudness = sound::loudness_of(block);
  });
  if (!is_permitted || !publisher_.demand().is_watched) return pause();
  constexpr std::chrono::milliseconds kLength{20};
  auto packets = voice_.say(block.samples, block.first_sample + kLength);
  if (!packets) return;  // a device that gives more than real time: only some of it is heard
  for (client::SpokenPacket& packet : *packets) send(std::move(packet));
}

/// Nothing is heard from now on.
void RoomMicrophone::pause() {
  if (auto last = voice_.pause()) send(*std::move(last));
}

void RoomMicrophone::send(client::SpokenPacket packet) {
  publisher_.say(std::move(packet.opus), packet.ends, packet.first_sample);
  change([](RoomMicrophoneStats& stats) { ++stats.packets_sent; });
}

/// Once for each refusal. Without a connection nothing is known.
void RoomMicrophone::tell_of_permission(bool is_permitted) {
  const bool is_refused = !is_permitted && !publisher_.problem();
  if (is_refused && !was_refused_ && log_)
    log_(LogLevel::kWarning,
         "this room does not let the sensor's microphone be heard: only its pictures are sent");
  was_refused_ = is_refused;
}

}  // namespace roomcast::sensor
