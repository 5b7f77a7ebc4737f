// SPDX-License-Identifier: Apache-2.0
// The functions of roomcast.h about people, their marks, and where sensors are.
#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "roomcast/capi/c_border.h"
#include "roomcast/capi/roomcast.h"
#include "roomcast/capi/viewer.h"
#include "roomcast/client/nudge.h"
#include "roomcast/client/room_requests.h"

struct roomcast_people {
  std::shared_ptr<const roomcast::client::RoomSnapshot> room;
};

namespace {

using namespace roomcast;

using capi::copy_known_part;
using capi::guarded;
using capi::known_part;
using capi::say;
using capi::text;

void write_part(const std::optional<RigidTransform>& part, std::int32_t& has, double* matrix) {
  has = part ? 1 : 0;
  if (part) std::ranges::copy(row_major_from_transform(*part), matrix);
}

roomcast_person describe_person(const client::RoomPerson& person, ViewerId self) {
  roomcast_person out{};
  out.id = person.id.value;
  out.r = person.color.r, out.g = person.color.g, out.b = person.color.b, out.a = 255;
  out.name = person.name.c_str();
  out.is_self = person.id == self ? 1 : 0;
  out.speaking = person.speaking ? 1 : 0;
  out.muted = person.muted ? 1 : 0;
  if (!person.pose) return out;
  write_part(person.pose->world_from_head, out.has_head, out.world_from_head);
  write_part(person.pose->world_from_left_hand, out.has_left_hand, out.world_from_left_hand);
  write_part(person.pose->world_from_right_hand, out.has_right_hand, out.world_from_right_hand);
  return out;
}

roomcast_mark describe_mark(const client::RoomMark& mark) {
  static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float));
  roomcast_mark out{};
  out.id = mark.id;
  out.kind = static_cast<std::int32_t>(mark.kind);
  out.points = mark.points_m.empty() ? nullptr : mark.points_m.front().data();
  out.point_count = mark.points_m.size();
  out.text = mark.text.c_str();
  out.author = mark.author.c_str();
  out.r = mark.color.r, out.g = mark.color.g, out.b = mark.color.b, out.a = 255;
  out.own = mark.own ? 1 : 0;
  return out;
}

Result<client::RoomMark> given_mark(const roomcast_mark* given) {
  const roomcast_mark known = known_part(given);
  if (known.kind < ROOMCAST_MARK_NOTE || known.kind > ROOMCAST_MARK_PLACE)
    return invalid_argument("a mark is a note, a sketch, a distance or a place");
  if (known.points == nullptr && known.point_count > 0) return invalid_argument("points is NULL");
  client::RoomMark mark;
  mark.kind = static_cast<client::MarkKind>(known.kind);
  mark.text = text(known.text);
  constexpr std::size_t kEnough = 10'000;  // more than any mark may have
  for (std::size_t i = 0; i < std::min(known.point_count, kEnough); ++i)
    mark.points_m.emplace_back(Eigen::Vector3f::Map(known.points + 3 * i));
  return mark;
}

std::shared_ptr<const client::RoomSnapshot> wait_people(roomcast_viewer& viewer,
                                                        const roomcast_people* known,
                                                        int timeout_ms) {
  using Steady = std::chrono::steady_clock;
  const auto until = Steady::now() + std::chrono::milliseconds(std::max(timeout_ms, 0));
  auto room = viewer.subscriber->snapshot();
  while (known != nullptr && room->people_revision == known->room->people_revision) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Steady::now());
    if (left.count() <= 0 || viewer.subscriber->failure()) return nullptr;
    room = viewer.subscriber->wait_newer(room->revision, left);
  }
  return room;
}

int answer_placed(const Result<client::PlacedSensor>& placed, roomcast_placement* placement,
                  char* error, std::size_t error_size) {
  if (!placed) {
    say(placed.error().message, error, error_size);
    return 0;
  }
  if (placement == nullptr) return 1;
  roomcast_placement out{};
  std::ranges::copy(row_major_from_transform(placed->world_from_depth), out.world_from_depth);
  out.expected_error_mm = placed->expected_error_mm;
  copy_known_part(out, *placement);
  return 1;
}

}  // namespace

extern "C" {

roomcast_people* roomcast_wait_people(roomcast_viewer* viewer, const roomcast_people* known,
                                      int timeout_ms) {
  return guarded<roomcast_people*>(nullptr, nullptr, 0, [&]() -> roomcast_people* {
    auto room = wait_people(*viewer, known, timeout_ms);
    return room ? new roomcast_people{std::move(room)} : nullptr;
  });
}

void roomcast_free_people(roomcast_people* people) {
  delete people;
}

size_t roomcast_person_count(const roomcast_people* people) {
  return people->room->people.size();
}

int roomcast_get_person(const roomcast_people* people, size_t number, roomcast_person* person) {
  if (number >= people->room->people.size()) return 0;
  copy_known_part(describe_person(people->room->people[number], people->room->self), *person);
  return 1;
}

size_t roomcast_mark_count(const roomcast_people* people) {
  return people->room->marks->size();
}

int roomcast_get_mark(const roomcast_people* people, size_t number, roomcast_mark* mark) {
  if (number >= people->room->marks->size()) return 0;
  copy_known_part(describe_mark((*people->room->marks)[number]), *mark);
  return 1;
}

int roomcast_leave_mark(roomcast_viewer* viewer, const roomcast_mark* given, uint32_t* id,
                        char* error, size_t error_size) {
  return guarded(0, error, error_size, [&] {
    const auto mark = given_mark(given);
    const std::lock_guard lock(viewer->asks);
    const auto left = mark ? client::leave_mark(*viewer->subscriber, *mark) : mark.error();
    if (!left) say(left.error().message, error, error_size);
    if (left && id != nullptr) *id = *left;
    return left ? 1 : 0;
  });
}

int roomcast_remove_mark(roomcast_viewer* viewer, uint32_t id, char* error, size_t error_size) {
  return guarded(0, error, error_size, [&] {
    const std::lock_guard lock(viewer->asks);
    const Status removed = client::remove_mark(*viewer->subscriber, id);
    if (!removed) say(removed.error().message, error, error_size);
    return removed ? 1 : 0;
  });
}

int roomcast_place_sensor(roomcast_viewer* viewer, const char* sensor,
                          const double* world_from_depth, roomcast_placement* placement,
                          char* error, size_t error_size) {
  return guarded(0, error, error_size, [&] {
    if (world_from_depth == nullptr) {
      say("world_from_depth is NULL", error, error_size);
      return 0;
    }
    const auto wanted = transform_from_row_major(std::span(world_from_depth, 16));
    const std::lock_guard lock(viewer->asks);
    return answer_placed(wanted
                             ? client::place_sensor(*viewer->subscriber, text(sensor),
                                                    [&](const RigidTransform&) { return *wanted; })
                             : wanted.error(),
                         placement, error, error_size);
  });
}

int roomcast_nudge_sensor(roomcast_viewer* viewer, const char* sensor, const roomcast_nudge* given,
                          roomcast_placement* placement, char* error, size_t error_size) {
  return guarded(0, error, error_size, [&] {
    const roomcast_nudge nudge = known_part(given);
    client::NudgeOptions by;
    by.shift_m = Eigen::Vector3d::Map(nudge.shift_m);
    by.turn_rad = nudge.turn_rad;
    by.tilt_rad = nudge.tilt_rad;
    if (const Status checked = client::check_nudge(by); !checked) {
      say(checked.error().message, error, error_size);
      return 0;
    }
    const std::lock_guard lock(viewer->asks);
    return answer_placed(
        client::place_sensor(*viewer->subscriber, text(sensor),
                             [&](const RigidTransform& pose) { return client::nudged(pose, by); }),
        placement, error, error_size);
  });
}

}  // extern "C"
