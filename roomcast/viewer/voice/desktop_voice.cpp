// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/voice/desktop_voice.h"

#include <algorithm>
#include <utility>

namespace roomcast::viewer {
namespace {

constexpr std::chrono::milliseconds kVoiceBlock{20}, kPacketPatience{100}, kDeviceRetry{2000};
constexpr std::chrono::milliseconds kForever{60'000};

}  // namespace

DesktopVoice::DesktopVoice(client::Subscriber& hub, VoiceSettings settings)
    : hub_(hub), settings_(std::move(settings)) {
  facts_.microphones = sound_devices(SoundDirection::kIn);
  facts_.loudspeakers = sound_devices(SoundDirection::kOut);
  packets_ = std::jthread([this](const std::stop_token& stop) { hear_packets(stop); });
  loudspeaker_ = std::jthread([this](const std::stop_token& stop) { play(stop); });
  microphone_ = std::jthread([this](const std::stop_token& stop) { listen(stop); });
}

DesktopVoice::~DesktopVoice() {
  for (std::jthread* thread : {&packets_, &loudspeaker_, &microphone_}) thread->request_stop();
  for (std::jthread* thread : {&packets_, &loudspeaker_, &microphone_}) thread->join();
}

void DesktopVoice::apply(const VoiceSettings& settings) {
  {
    const std::lock_guard lock(mutex_);
    if (settings == settings_) return;
    settings_ = settings;
  }
  changed_.notify_all();
}

void DesktopVoice::stand(const RigidTransform& world_from_head) {
  const std::lock_guard lock(mutex_);
  world_from_head_ = world_from_head;
}

VoiceFacts DesktopVoice::facts() const {
  const std::lock_guard lock(mutex_);
  VoiceFacts facts = facts_;
  facts.heard = mix_.speakers();
  return facts;
}

VoiceSettings DesktopVoice::settings() const {
  const std::lock_guard lock(mutex_);
  return settings_;
}

bool DesktopVoice::wait_for_change(const VoiceSettings& known, std::chrono::milliseconds patience,
                                   const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, stop, patience, [&] { return !(settings_ == known); });
  return !stop.stop_requested();
}

void DesktopVoice::hear_packets(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    auto packet = hub_.next_voice(kPacketPatience);
    if (!packet) {
      // At once after the connection has ended for good.
      if (hub_.failure() && !wait_for_change(settings(), kPacketPatience, stop)) return;
      continue;
    }
    const HostTime now = SteadyClock().now();
    const std::lock_guard lock(mutex_);
    mix_.take(*std::move(packet), now);
  }
}

// ---- The loudspeaker

void DesktopVoice::play(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const VoiceSettings chosen = settings();
    auto loudspeaker = open_loudspeaker(chosen.loudspeaker);
    change([&](VoiceFacts& facts) {
      facts.loudspeaker_problem = loudspeaker ? "" : loudspeaker.error().message;
    });
    if (loudspeaker) {
      play_on(loudspeaker->get(), chosen.loudspeaker, stop);
    } else if (!wait_for_change(chosen, kDeviceRetry, stop)) {
      return;
    }
  }
}

/// Until another one is chosen, or it is gone. Null: into the void.
void DesktopVoice::play_on(sound::Loudspeaker* loudspeaker, const std::string& device,
                           const std::stop_token& stop) {
  while (settings().loudspeaker == device) {
    const sound::StereoBlock block = next_block();
    if (loudspeaker == nullptr) {
      if (!wait_for_change(settings(), kVoiceBlock, stop)) return;
      continue;
    }
    const auto played = loudspeaker->play(block, stop);
    if (!played) {
      change([&](VoiceFacts& facts) { facts.loudspeaker_problem = played.error().message; });
      static_cast<void>(wait_for_change(settings(), kDeviceRetry, stop));
      return;
    }
    if (!*played) return;
    played_.push(block);
  }
}

sound::StereoBlock DesktopVoice::next_block() {
  const auto room = hub_.snapshot();
  const HostTime now = SteadyClock().now();
  const std::lock_guard lock(mutex_);
  const sound::StereoBlock block = mix_.mix(*room, world_from_head_, settings_.volumes, now);
  return settings_.hears ? block : sound::StereoBlock{};
}

// ---- The microphone

void DesktopVoice::listen(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    const VoiceSettings chosen = settings();
    if (!chosen.microphone_on) {
      change([](VoiceFacts& facts) { facts.microphone_problem.clear(); });
      if (!wait_for_change(chosen, kForever, stop)) return;
      continue;
    }
    auto microphone = open_microphone(chosen.microphone);
    change([&](VoiceFacts& facts) {
      facts.microphone_problem = microphone ? "" : microphone.error().message;
    });
    if (microphone) {
      canceller_.restart();
      listen_on(**microphone, chosen.microphone, stop);
      pause_speaking();
    } else if (!wait_for_change(chosen, kDeviceRetry, stop)) {
      return;
    }
  }
}

/// Until it is turned off, another one is chosen, or it is gone.
void DesktopVoice::listen_on(sound::Microphone& microphone, const std::string& device,
                             const std::stop_token& stop) {
  for (;;) {
    const VoiceSettings now = settings();
    if (!now.microphone_on || now.microphone != device) return;
    auto block = microphone.next(stop);
    if (block && *block) {
      take(**block);
      continue;
    }
    if (!block) {
      change([&](VoiceFacts& facts) { facts.microphone_problem = block.error().message; });
      static_cast<void>(wait_for_change(now, kDeviceRetry, stop));
    }
    return;
  }
}

void DesktopVoice::take(sound::Microphone::Block& block) {
  canceller_.process(block.samples, played_.take());
  const VoiceSettings now = settings();
  const bool is_open = gate_.is_open(block.samples, now.mode, now.is_pushed);
  const std::string in_the_way = obstacle();
  const bool is_sent = is_open && in_the_way.empty();
  change([&](VoiceFacts& facts) {
    facts.loudness = voice::loudness_of(block.samples);
    facts.is_sending = is_sent;
    facts.microphone_problem = in_the_way;
  });
  say(block, is_sent);
}

/// Why nobody would hear this person; empty: nothing is in the way.
std::string DesktopVoice::obstacle() const {
  const auto room = hub_.snapshot();
  if (!room->connected) return "nobody hears you while there is no connection to the hub";
  if (const Status may = client::check_may_speak(room->rights); !may) return may.error().message;
  const auto self = std::ranges::find(room->people, room->self, &client::RoomPerson::id);
  if (self != room->people.end() && self->muted) return "an admin has muted you: nobody hears you";
  return "";
}

void DesktopVoice::say(sound::Microphone::Block& block, bool is_sent) {
  if (!is_sent) return pause_speaking();
  auto packets = spoken_.say(block.samples, block.first_sample + kVoiceBlock);
  if (!packets) return;  // a device that gives more than real time: only some of it is heard
  for (client::SpokenPacket& packet : *packets)
    hub_.say(std::move(packet.opus), packet.ends, packet.first_sample);
}

void DesktopVoice::pause_speaking() {
  change([](VoiceFacts& facts) { facts.is_sending = false; });
  if (auto last = spoken_.pause()) hub_.say(std::move(last->opus), last->ends, last->first_sample);
}

}  // namespace roomcast::viewer
