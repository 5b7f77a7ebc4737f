// SPDX-License-Identifier: Apache-2.0
// DesktopVoice: a person at a desktop listens and speaks: the room's voices to the loudspeaker, and
// the microphone to the hub, without the loudspeaker's echo and without noise. Devices that are not
// there, or go away, are looked for; meanwhile VoiceFacts says what is wrong. Threading: has three
// threads, for packets, loudspeaker and microphone; the methods are thread-safe.
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

#include "roomcast/client/subscriber.h"
#include "roomcast/client/voices/spoken_voice.h"
#include "roomcast/viewer/voice/played_sound.h"
#include "roomcast/viewer/voice/room_mix.h"
#include "roomcast/viewer/voice/sound_devices.h"
#include "roomcast/viewer/voice/voice_settings.h"
#include "roomcast/voice/echo_canceller.h"

namespace roomcast::viewer {

class DesktopVoice {
 public:
  /// `hub` must have joined with `hears`, and outlive this.
  DesktopVoice(client::Subscriber& hub, VoiceSettings settings);
  ~DesktopVoice();

  void apply(const VoiceSettings& settings);
  /// The listener's head.
  void stand(const RigidTransform& world_from_head);
  [[nodiscard]] VoiceFacts facts() const;

 private:
  void hear_packets(const std::stop_token& stop);
  void play(const std::stop_token& stop);
  void play_on(sound::Loudspeaker* loudspeaker, const std::string& device,
               const std::stop_token& stop);
  [[nodiscard]] sound::StereoBlock next_block();
  void listen(const std::stop_token& stop);
  void listen_on(sound::Microphone& microphone, const std::string& device,
                 const std::stop_token& stop);
  void take(sound::Microphone::Block& block);
  void say(sound::Microphone::Block& block, bool is_sent);
  void pause_speaking();
  [[nodiscard]] std::string obstacle() const;
  [[nodiscard]] VoiceSettings settings() const;
  /// False: `stop` was requested.
  bool wait_for_change(const VoiceSettings& known, std::chrono::milliseconds patience,
                       const std::stop_token& stop);
  template <class Change>
  void change(Change how) {
    const std::lock_guard lock(mutex_);
    how(facts_);
  }

  client::Subscriber& hub_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  VoiceSettings settings_;
  VoiceFacts facts_;
  RigidTransform world_from_head_;
  RoomMix mix_;
  PlayedSound played_;
  // Used by the microphone's thread only.
  voice::EchoCanceller canceller_;
  voice::TalkGate gate_;
  client::SpokenVoice spoken_;

  std::jthread packets_, loudspeaker_, microphone_;  // last: they use all of the above
};

}  // namespace roomcast::viewer
