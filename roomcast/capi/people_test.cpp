// SPDX-License-Identifier: Apache-2.0
// People, their marks, and where sensors are, through the C functions and a real hub.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "roomcast/capi/room_fixture.h"
#include "roomcast/client/hub_link.h"
#include "roomcast/client/network_thread.h"
#include "roomcast/hub/server/running_hub.h"

namespace roomcast::capi {
namespace {

constexpr std::array<double, 16> kHead{1, 0, 0, 0.5, 0, 1, 0, 1.5, 0, 0, 1, 2, 0, 0, 0, 1};
constexpr std::array<float, 3> kPoint{1, 0.5, -2};

/// The person of this name as `viewer` sees it now; size 0: nobody.
roomcast_person person_named(const Viewer& viewer, const std::string& name, People& keeps) {
  keeps.reset(roomcast_wait_people(viewer.get(), nullptr, 0));
  for (std::size_t i = 0; i < roomcast_person_count(keeps.get()); ++i) {
    roomcast_person person{};
    person.size = sizeof(person);
    EXPECT_EQ(roomcast_get_person(keeps.get(), i, &person), 1);
    if (person.name == name) return person;
  }
  return {};
}

roomcast_mark note_of(const char* words) {
  roomcast_mark mark{};
  mark.size = sizeof(mark);
  mark.kind = ROOMCAST_MARK_NOTE;
  mark.points = kPoint.data();
  mark.point_count = 1;
  mark.text = words;
  return mark;
}

std::vector<roomcast_mark> marks_of(const People& people) {
  std::vector<roomcast_mark> marks(roomcast_mark_count(people.get()));
  for (std::size_t i = 0; i < marks.size(); ++i) {
    marks[i].size = sizeof(roomcast_mark);
    EXPECT_EQ(roomcast_get_mark(people.get(), i, &marks[i]), 1);
  }
  roomcast_mark none{};
  none.size = sizeof(none);
  EXPECT_EQ(roomcast_get_mark(people.get(), marks.size(), &none), 0);
  return marks;
}

TEST(PeopleOfARoom, somebodys_head_is_seen_by_the_others) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada")), ben = join(joining(url, "Ben"));
  const roomcast_pose pose{sizeof(roomcast_pose), kHead.data(), nullptr, kHead.data()};
  roomcast_person seen{};
  People keeps;
  ASSERT_TRUE(until([&] {
    roomcast_send_pose(ada.get(), &pose, nullptr, 0);
    seen = person_named(ben, "Ada", keeps);
    return seen.has_head == 1;
  }));
  for (std::size_t i = 0; i < 16; ++i) EXPECT_NEAR(seen.world_from_head[i], kHead[i], 1e-5);
  EXPECT_EQ(seen.has_left_hand, 0);
  EXPECT_EQ(seen.has_right_hand, 1);
  EXPECT_EQ(seen.is_self, 0);
  EXPECT_EQ(seen.a, 255);
  EXPECT_EQ(person_named(ben, "Ben", keeps).is_self, 1);
}

TEST(PeopleOfARoom, a_wait_ends_when_something_changes_and_not_before) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada"));
  People now;
  ASSERT_TRUE(until([&] { return person_named(ada, "Ada", now).size != 0; }));
  while (People later{roomcast_wait_people(ada.get(), now.get(), 300)}) now = std::move(later);
  const Viewer ben = join(joining(url, "Ben"));
  const People later(roomcast_wait_people(ada.get(), now.get(), 10'000));
  ASSERT_NE(later, nullptr);
  EXPECT_EQ(roomcast_person_count(later.get()), 2u);
  EXPECT_EQ(roomcast_person_count(now.get()), 1u) << "what was received stays as it was";
  roomcast_person none{};
  none.size = sizeof(none);
  EXPECT_EQ(roomcast_get_person(later.get(), 2, &none), 0);
}

TEST(Marks, what_one_leaves_the_others_see_and_only_its_author_removes) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada")), ben = join(joining(url, "Ben"));
  const roomcast_mark note = note_of("a leak \xC3\xBC");
  std::uint32_t id = 0;
  char error[300] = "";
  ASSERT_EQ(roomcast_leave_mark(ada.get(), &note, &id, error, sizeof(error)), 1) << error;
  People seen;
  ASSERT_TRUE(until([&] {
    seen.reset(roomcast_wait_people(ben.get(), nullptr, 0));
    return roomcast_mark_count(seen.get()) == 1;
  }));
  const roomcast_mark mark = marks_of(seen).front();
  EXPECT_EQ(mark.id, id);
  EXPECT_EQ(mark.kind, ROOMCAST_MARK_NOTE);
  EXPECT_STREQ(mark.text, "a leak \xC3\xBC");
  EXPECT_STREQ(mark.author, "Ada");
  EXPECT_EQ(mark.own, 0);
  ASSERT_EQ(mark.point_count, 1u);
  EXPECT_TRUE(std::equal(kPoint.begin(), kPoint.end(), mark.points));
  EXPECT_EQ(roomcast_remove_mark(ben.get(), id, error, sizeof(error)), 0);
  EXPECT_STREQ(error, "only its author and the room's admins can remove a mark");
  ASSERT_EQ(roomcast_remove_mark(ada.get(), id, error, sizeof(error)), 1) << error;
  EXPECT_EQ(roomcast_remove_mark(ada.get(), id, error, sizeof(error)), 0);
  EXPECT_TRUE(until([&] {
    seen.reset(roomcast_wait_people(ben.get(), nullptr, 0));
    return roomcast_mark_count(seen.get()) == 0;
  }));
}

TEST(Marks, a_program_that_comes_back_with_its_key_owns_what_it_left) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  roomcast_options options = joining(url, "Ada");
  options.author_key = "Ada's secret";
  const roomcast_mark note = note_of("mine");
  std::uint32_t id = 0;
  ASSERT_EQ(roomcast_leave_mark(join(options).get(), &note, &id, nullptr, 0), 1);
  const Viewer again = join(options);
  People seen;
  ASSERT_TRUE(until([&] {
    seen.reset(roomcast_wait_people(again.get(), nullptr, 0));
    return roomcast_mark_count(seen.get()) == 1;
  }));
  EXPECT_EQ(marks_of(seen).front().own, 1);
  EXPECT_EQ(roomcast_remove_mark(again.get(), id, nullptr, 0), 1);
}

TEST(Marks, two_threads_leave_marks_of_their_own) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada"));
  std::array<std::uint32_t, 4> ids{};
  {
    std::vector<std::jthread> threads;
    for (std::uint32_t& id : ids) {
      threads.emplace_back([&] {
        const roomcast_mark note = note_of("the same words");
        EXPECT_EQ(roomcast_leave_mark(ada.get(), &note, &id, nullptr, 0), 1);
      });
    }
  }
  std::ranges::sort(ids);
  EXPECT_EQ(std::ranges::adjacent_find(ids), ids.end());
}

TEST(Marks, what_cannot_be_left_is_refused_with_a_sentence) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada"));
  const auto refused = [&](auto spoil) {
    roomcast_mark mark = note_of("words");
    spoil(mark);
    char error[300] = "";
    EXPECT_EQ(roomcast_leave_mark(ada.get(), &mark, nullptr, error, sizeof(error)), 0);
    return std::string(error);
  };
  const std::string long_text(281, 'x');
  for (const std::string& sentence : {
           refused([](auto& m) { m.kind = 0; }),
           refused([](auto& m) { m.kind = 9; }),
           refused([](auto& m) { m.points = nullptr; }),
           refused([](auto& m) { m.text = nullptr; }),
           refused([](auto& m) { m.text = "\xff"; }),
           refused([](auto& m) { m.kind = ROOMCAST_MARK_SKETCH; }),
           refused([&](auto& m) { m.text = long_text.c_str(); }),
       }) {
    EXPECT_NE(sentence, "");
  }
  EXPECT_EQ(roomcast_leave_mark(ada.get(), nullptr, nullptr, nullptr, 0), 0);
}

TEST(Marks, a_program_of_an_earlier_header_gets_the_part_that_it_knows) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Viewer ada = join(joining(url, "Ada"));
  const roomcast_mark note = note_of("words");
  ASSERT_EQ(roomcast_leave_mark(ada.get(), &note, nullptr, nullptr, 0), 1);
  const People seen(roomcast_wait_people(ada.get(), nullptr, 0));
  roomcast_mark mark{};
  mark.size = offsetof(roomcast_mark, points);
  ASSERT_EQ(roomcast_get_mark(seen.get(), 0, &mark), 1);
  EXPECT_EQ(mark.kind, ROOMCAST_MARK_NOTE);
  EXPECT_EQ(mark.points, nullptr);
}

/// Takes every proposed pose as it is, and expects 7 mm.
class TrustingAligner final : public client::HubLinkEvents {
 public:
  explicit TrustingAligner(const hub::RunningHub& hub)
      : link_(network_.io(), *net::parse_hub_urls(hub.url()), joins(hub), *this) {
    link_.start();
    network_.start();
  }
  ~TrustingAligner() override {
    network_.finish([this] { link_.stop(); });
  }

  std::atomic<bool> joined = false;

  void on_welcome(const wire::pb::Welcome&) override { joined = true; }
  void on_control(const wire::pb::Control& message) override {
    if (!message.has_nudge()) return;
    wire::pb::Control answer;
    auto& found = *answer.mutable_placements()->add_sensors();
    found.set_sensor_id(message.nudge().sensor_id());
    *found.mutable_world_from_depth() = message.nudge().world_from_depth();
    found.set_expected_error_mm(7);
    link_.send(answer);
  }
  void on_frame(net::MessageBuffer) override {}
  net::FramedMessagePtr next_frame() override { return nullptr; }
  void on_clock(const client::ClockEstimate&) override {}
  void on_down(const Error&, bool) override {}

 private:
  static wire::pb::Join joins(const hub::RunningHub& hub) {
    wire::pb::Join join;
    join.set_token(hub.server().own_token());
    join.mutable_aligner();
    return join;
  }
  client::NetworkThread network_;
  client::HubLink link_;
};

Publisher unplaced_sensor(const std::string& url, const double* world_from_depth = nullptr) {
  static constexpr roomcast_camera kCamera{sizeof(kCamera), 80, 60, 70, 70, 40, 30, 0, 0, 0, 0, 0};
  roomcast_sensor_options sensor{};
  sensor.size = sizeof(sensor);
  sensor.depth = &kCamera;
  sensor.world_from_depth = world_from_depth;
  const roomcast_options options = joining(url, "left");
  return Publisher(roomcast_publish(&options, &sensor, nullptr, 0));
}

Viewer join_as_admin(const hub::RunningHub& hub, const std::string& url) {
  roomcast_options options = joining(url, "admin");
  options.token = hub.server().own_token().c_str();
  return join(options);
}

TEST(PlacingSensors, an_admin_places_and_nudges_a_sensor) {
  const hub::RunningHub hub;
  const TrustingAligner aligner(hub);
  const std::string url = hub.url();
  const Publisher sensor = unplaced_sensor(url);
  ASSERT_NE(sensor, nullptr);
  ASSERT_TRUE(until([&] { return aligner.joined.load(); }));
  const Viewer admin = join_as_admin(hub, url);
  roomcast_placement placed{};
  placed.size = sizeof(placed);
  char error[300] = "";
  ASSERT_EQ(roomcast_place_sensor(admin.get(), "left", kHead.data(), &placed, error, sizeof(error)),
            1)
      << error;
  EXPECT_TRUE(std::ranges::equal(placed.world_from_depth, kHead));
  EXPECT_EQ(placed.expected_error_mm, 7);
  const roomcast_nudge nudge{sizeof(nudge), {0.25, 0, -1}, 0, 0};
  ASSERT_EQ(roomcast_nudge_sensor(admin.get(), "left", &nudge, &placed, error, sizeof(error)), 1)
      << error;
  EXPECT_DOUBLE_EQ(placed.world_from_depth[3], 0.75);
  EXPECT_DOUBLE_EQ(placed.world_from_depth[11], 1);
}

TEST(PlacingSensors, what_is_not_possible_is_told_at_once) {
  const hub::RunningHub hub;
  const std::string url = hub.url();
  const Publisher sensor = unplaced_sensor(url, kHead.data());
  const Viewer admin = join_as_admin(hub, url), guest = join(joining(url, "guest"));
  const auto refused = [](const Viewer& viewer, const char* name, const double* pose) {
    char error[300] = "";
    EXPECT_EQ(roomcast_place_sensor(viewer.get(), name, pose, nullptr, error, sizeof(error)), 0);
    return std::string(error);
  };
  EXPECT_EQ(refused(guest, "left", kHead.data()),
            "to move a sensor takes an admin's token (roomcast token --role admin)");
  EXPECT_EQ(refused(admin, "right", kHead.data()), "the room has no sensor \"right\"");
  EXPECT_NE(refused(admin, "left", kHead.data()).find("has supplied its pose"), std::string::npos);
  EXPECT_EQ(refused(admin, "left", nullptr), "world_from_depth is NULL");
  const std::array<double, 16> no_rotation{};
  EXPECT_NE(refused(admin, "left", no_rotation.data()), "");
  const roomcast_nudge nudge{sizeof(nudge), {std::nan(""), 0, 0}, 0, 0};
  EXPECT_EQ(roomcast_nudge_sensor(admin.get(), "left", &nudge, nullptr, nullptr, 0), 0);
}

}  // namespace
}  // namespace roomcast::capi
