// SPDX-License-Identifier: Apache-2.0
// Voices through the C functions and a real hub.
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/capi/room_fixture.h"
#include "roomcast/hub/server/running_hub.h"

namespace roomcast::capi {
namespace {

using namespace std::chrono_literals;

/// 440 Hz, from the `from`th sample on.
std::vector<float> hum(std::size_t from, std::size_t count) {
  std::vector<float> samples(count);
  for (std::size_t i = 0; i < count; ++i)
    samples[i] = 0.5F * std::sin(2 * std::numbers::pi_v<float> * 440 *
                                 static_cast<float>(from + i) / ROOMCAST_VOICE_RATE_HZ);
  return samples;
}

/// A packet with the memory that it takes.
struct Listening {
  Listening() {
    voice.size = sizeof(voice);
    voice.samples = samples.data();
    voice.opus = opus.data();
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

  std::array<float, ROOMCAST_VOICE_SAMPLES> samples{};
  std::array<std::uint8_t, ROOMCAST_VOICE_MAX_BYTES> opus{};
  roomcast_voice voice{};
};

Viewer listener(const std::string& url) {
  roomcast_options options = joining(url, "Ben");
  options.hears = 1;
  return join(options);
}

std::uint32_t id_of(const Viewer& viewer, const std::string& name) {
  const People people(roomcast_wait_people(viewer.get(), nullptr, 0));
  for (std::size_t i = 0; i < roomcast_person_count(people.get()); ++i) {
    roomcast_person person{};
    person.size = sizeof(person);
    if (roomcast_get_person(people.get(), i, &person) == 1 && person.name == name) return person.id;
  }
  return 0;
}

TEST(Voices, what_one_says_the_others_hear_and_know_where_it_comes_from) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada")), ben = listener(url);
  ASSERT_TRUE(until([&] { return id_of(ben, "Ada") != 0; }));
  std::this_thread::sleep_for(300ms);  // room time is known by now
  const std::array<double, 16> head{1, 0, 0, 0.5, 0, 1, 0, 1.5, 0, 0, 1, 2, 0, 0, 0, 1};
  const roomcast_pose pose{sizeof(roomcast_pose), head.data(), nullptr, nullptr};
  Listening heard;
  double loudest = 0;
  std::size_t said = 0, packets = 0;
  bool had_head = false;
  ASSERT_TRUE(until([&] {
    roomcast_send_pose(ada.get(), &pose, nullptr, 0);
    char error[300] = "";
    EXPECT_EQ(roomcast_speak(ada.get(), hum(said, 1440).data(), 1440, error, sizeof(error)), 1)
        << error;
    said += 1440;
    for (int i = 0; i < 3 && roomcast_next_voice(ben.get(), 10, &heard.voice) == 1; ++i) {
      EXPECT_EQ(heard.voice.speaker, id_of(ben, "Ada"));
      EXPECT_EQ(heard.voice.seq, packets++);
      EXPECT_GT(heard.voice.opus_bytes, 0u);
      EXPECT_EQ(heard.voice.ends, 0);
      for (const float sample : heard.samples) loudest = std::max(loudest, double{sample});
      had_head = heard.voice.has_head == 1 && std::abs(heard.voice.world_from_head[7] - 1.5) < 1e-5;
    }
    std::this_thread::sleep_for(15ms);
    return packets > 20 && had_head;
  }));
  EXPECT_NEAR(loudest, 0.5, 0.1);
  EXPECT_LT(std::abs(heard.voice.capture_ns - roomcast_host_time_ns()), 2'000'000'000);

  roomcast_pause_speaking(ada.get());
  roomcast_pause_speaking(ada.get());  // nothing was said since
  ASSERT_TRUE(until([&] {
    return roomcast_next_voice(ben.get(), 10, &heard.voice) == 1 && heard.voice.ends == 1;
  }));
  EXPECT_EQ(roomcast_next_voice(ben.get(), 50, &heard.voice), 0);
}

TEST(Voices, only_who_asked_for_them_hears_them) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada")), deaf = join(joining(url, "Cleo"));
  const Viewer ben = listener(url);
  Listening heard;
  ASSERT_TRUE(until([&] {
    EXPECT_EQ(roomcast_speak(ada.get(), hum(0, 960).data(), 960, nullptr, 0), 1);
    std::this_thread::sleep_for(20ms);
    return roomcast_next_voice(ben.get(), 0, &heard.voice) == 1;
  }));
  EXPECT_EQ(roomcast_next_voice(deaf.get(), 20, &heard.voice), 0);
  ASSERT_TRUE(until([&] {  // the hub tells who speaks
    EXPECT_EQ(roomcast_speak(ada.get(), hum(0, 960).data(), 960, nullptr, 0), 1);
    std::this_thread::sleep_for(20ms);
    const People people(roomcast_wait_people(ben.get(), nullptr, 0));
    roomcast_person person{};
    person.size = sizeof(person);
    for (std::size_t i = 0; roomcast_get_person(people.get(), i, &person) == 1; ++i) {
      if (person.speaking == 1) return person.name == std::string("Ada");
    }
    return false;
  }));
}

TEST(Voices, a_room_that_lets_nobody_speak_says_so) {
  hub::HubOptions options;
  options.rooms[0].speak = hub::AccessRule::kNobody;
  const hub::RunningHub hub(options);
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada"));
  char error[300] = "";
  EXPECT_EQ(roomcast_may_speak(ada.get(), error, sizeof(error)), 0);
  EXPECT_STREQ(error, "this room does not let you speak");
  EXPECT_EQ(roomcast_speak(ada.get(), hum(0, 960).data(), 960, error, sizeof(error)), 0);
  EXPECT_EQ(roomcast_is_connected(ada.get(), error, sizeof(error)), 1) << error;
}

TEST(Voices, more_than_one_person_speaks_is_refused_and_the_connection_stays) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada"));
  EXPECT_EQ(roomcast_may_speak(ada.get(), nullptr, 0), 1);
  const auto second = hum(0, 48'000);
  char error[300] = "";
  ASSERT_TRUE(until([&] {
    return roomcast_speak(ada.get(), second.data(), second.size(), error, sizeof(error)) == 0;
  }));
  EXPECT_NE(std::string(error).find("ahead of time"), std::string::npos) << error;
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(roomcast_is_connected(ada.get(), error, sizeof(error)), 1) << error;
}

TEST(Voices, a_caller_that_wants_neither_sound_nor_packet_learns_who_spoke) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada")), ben = listener(url);
  roomcast_voice voice{};
  voice.size = sizeof(voice);
  ASSERT_TRUE(until([&] {
    roomcast_speak(ada.get(), hum(0, 960).data(), 960, nullptr, 0);
    std::this_thread::sleep_for(20ms);
    return roomcast_next_voice(ben.get(), 0, &voice) == 1;
  }));
  EXPECT_EQ(voice.speaker, id_of(ben, "Ada"));
  EXPECT_GT(voice.opus_bytes, 0u);
}

}  // namespace
}  // namespace roomcast::capi
