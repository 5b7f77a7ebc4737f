// SPDX-License-Identifier: Apache-2.0
// A person at a desktop whose microphone and loudspeaker are WAV files.
#include "roomcast/viewer/voice/desktop_voice.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "roomcast/client/hub_fixture.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/core/temporary_folder.h"
#include "roomcast/sound/wav_fixture.h"
#include "roomcast/sound/wav_sound.h"
#include "roomcast/voice/voice_encoder.h"

namespace roomcast::viewer {
namespace {

using namespace std::chrono_literals;

class DesktopVoiceTest : public testing::Test {
 protected:
  DesktopVoiceTest() {
    ::setenv("SDL_AUDIODRIVER", "dummy", 1);
    network.start();
    sound::write_wav(folder / "tone.wav", sound::tone(440, 1));
    settings.microphone = (folder / "tone.wav").string();
    settings.loudspeaker = "none";
    settings.mode = voice::TalkMode::kPush;
  }
  ~DesktopVoiceTest() override {
    voice.reset();
    subscriber.reset();
    network.finish([this] { hub.reset(); });
  }
  void join(bool lets_speak = true) {
    network.run([&] { hub->lets_speak = lets_speak; });
    auto joined = client::Subscriber::open(
        {.hub_url = hub->url(), .room = {}, .name = "Ada", .hears = true, .log = {}});
    ASSERT_TRUE(joined.ok()) << joined.error().message;
    subscriber = *std::move(joined);
    voice.emplace(*subscriber, settings);
  }
  void change(auto how) {
    how(settings);
    voice->apply(settings);
  }
  std::vector<wire::AudioHeader> said() {
    std::vector<wire::AudioHeader> voices;
    network.run([&] { voices = hub->voices; });
    return voices;
  }
  /// 20 ms of a tone by somebody else, as the hub forwards it.
  void speak(std::uint32_t seq) {
    std::array<float, voice::kPacketSamples> samples{};
    std::ranges::copy_n(sound::tone(1000, 0.02).begin(), samples.size(), samples.begin());
    const auto opus = encoder.encode(samples);
    std::vector<std::uint8_t> bytes(wire::kAudioHeaderBytes);
    wire::write_audio_header({.speaker = ViewerId{9},
                              .seq = seq,
                              .capture_time = RoomTime(seq * 20ms),
                              .payload_length = static_cast<std::uint16_t>(opus.size())},
                             std::span(bytes).first<wire::kAudioHeaderBytes>());
    bytes.insert(bytes.end(), opus.begin(), opus.end());
    network.run([&] { hub->say(net::frame_message(net::MessageBuffer(bytes))); });
  }

  TemporaryFolder folder;
  client::NetworkThread network;
  std::optional<client::FakeHub> hub{std::in_place, network.io()};
  std::unique_ptr<client::Subscriber> subscriber;
  VoiceSettings settings;
  voice::VoiceEncoder encoder;
  std::optional<DesktopVoice> voice;
};

TEST_F(DesktopVoiceTest,
       the_microphone_is_off_until_it_is_turned_on_and_speaks_while_the_key_is_held) {
  join();
  std::this_thread::sleep_for(100ms);  // nothing happens
  EXPECT_TRUE(said().empty());
  change([](VoiceSettings& s) { s.microphone_on = s.is_pushed = true; });
  ASSERT_TRUE(client::wait_until_true([this] { return said().size() > 5; }));
  EXPECT_TRUE(voice->facts().is_sending);
  change([](VoiceSettings& s) { s.is_pushed = false; });
  ASSERT_TRUE(client::wait_until_true([this] { return said().back().ends; }));
  EXPECT_TRUE(client::wait_until_true([this] { return !voice->facts().is_sending; }));
}

TEST_F(DesktopVoiceTest, what_others_say_is_played) {
  settings.loudspeaker = (folder / "heard.wav").string();
  join();
  for (std::uint32_t n = 0; n < 40; ++n) {
    speak(n);
    std::this_thread::sleep_for(20ms);
  }
  EXPECT_EQ(voice->facts().heard, std::set<ViewerId>{ViewerId{9}});
  voice.reset();
  const auto heard = sound::read_wav(folder / "heard.wav");
  ASSERT_TRUE(heard.ok()) << heard.error().message;
  double loudest = 0;
  const std::vector<float> samples = sound::one_channel(*heard);
  for (std::size_t at = 0; at + 4800 < samples.size(); at += 960)
    loudest = std::max(loudest, sound::amplitude_of(1000, std::span(samples).subspan(at, 4800)));
  EXPECT_NEAR(loudest, 0.4 / std::sqrt(2), 0.06) << "in the middle, by constant power";
}

TEST_F(DesktopVoiceTest, who_does_not_want_to_hear_plays_silence) {
  settings.loudspeaker = (folder / "silent.wav").string();
  settings.hears = false;
  join();
  for (std::uint32_t n = 0; n < 15; ++n) {
    speak(n);
    std::this_thread::sleep_for(20ms);
  }
  voice.reset();
  const auto heard = sound::read_wav(folder / "silent.wav");
  ASSERT_TRUE(heard.ok());
  for (const float sample : heard->samples) EXPECT_EQ(sample, 0);
}

TEST_F(DesktopVoiceTest, what_is_in_the_way_is_said) {
  settings.microphone_on = settings.is_pushed = true;
  join(false);
  EXPECT_TRUE(client::wait_until_true(
      [this] { return voice->facts().microphone_problem == "this room does not let you speak"; }));
  EXPECT_TRUE(said().empty());
  change([](VoiceSettings& s) { s.microphone = "/none/at/all.wav"; });
  EXPECT_TRUE(client::wait_until_true([this] {
    return voice->facts().microphone_problem.find("/none/at/all.wav") != std::string::npos;
  }));
  change([](VoiceSettings& s) { s.loudspeaker = "there is no such device"; });
  EXPECT_TRUE(
      client::wait_until_true([this] { return !voice->facts().loudspeaker_problem.empty(); }));
  change([](VoiceSettings& s) { s.microphone_on = false; });
  EXPECT_TRUE(
      client::wait_until_true([this] { return voice->facts().microphone_problem.empty(); }));
}

}  // namespace
}  // namespace roomcast::viewer
