// SPDX-License-Identifier: Apache-2.0
// Bindings of the people in a live room (heads, marks, voices), and of the sensors' places.
#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "roomcast/client/nudge.h"
#include "roomcast/client/room/speaker.h"
#include "roomcast/client/room_requests.h"
#include "roomcast/client/voices/speak.h"
#include "roomcast/python/arrays.h"
#include "roomcast/python/watched_room.h"
#include "roomcast/python/without_gil.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

using client::MarkKind;
using client::PersonPose;
using client::RoomMark;
using client::RoomPerson;
using client::VoiceListener;
using Color3 = std::tuple<int, int, int>;

constexpr std::array<std::pair<MarkKind, const char*>, 4> kMarkKinds{{
    {MarkKind::kNote, "note"},
    {MarkKind::kSketch, "sketch"},
    {MarkKind::kDistance, "distance"},
    {MarkKind::kPlace, "place"},
}};

constexpr const char* kLeaveMarkDoc =
    "Leaves a mark in the room for everybody, and returns its ID.\n\n"
    "kind: 'note' (words at one point), 'sketch' (a line of 2 to 512 points), 'distance'\n"
    "(between two points) or 'place' (a name, where somebody stands, and what they look at).\n"
    "points: N x 3, metres, in the room's frame. Raises Error if the hub does not take it.";
constexpr const char* kNextVoiceDoc =
    "The next 20 ms of somebody's voice, of a room joined with hears=True; None after\n"
    "timeout_s (None: waits as long as it takes). Those of each speaker come in their order.";
constexpr const char* kSpeakDoc =
    "Says this to the others in the room: samples at 48 kHz, -1 to 1, that were recorded\n"
    "since the last call, up to a second and not faster than real time.";
constexpr const char* kPlaceDoc =
    "Proposes a pose (4 x 4) for a sensor; the room's aligner refines it and accepts it, or\n"
    "refuses it with a reason. Returns the refined pose and the error to be expected 2.5 m\n"
    "ahead of the sensor, in millimetres. Takes an admin's token, a sensor that did not\n"
    "supply its pose, and up to 20 s.";
constexpr const char* kNudgeDoc =
    "As place(), from where the sensor stands: tilts it upwards and turns it counter-clockwise\n"
    "as seen from above, about its own position, then shifts it (x, y, z in metres).";

struct NamedPerson {
  RoomPerson person;
  bool is_self = false;
};

Color3 color_of(Rgb8 color) {
  return {color.r, color.g, color.b};
}

py::object part_of(const RoomPerson& person, std::optional<RigidTransform> PersonPose::*part) {
  return array_or_none(person.pose ? (*person.pose).*part : std::nullopt);
}

py::object head_of(const RoomPerson& person) {
  if (!person.pose) return py::none();
  return array_of(person.pose->world_from_head);
}

std::vector<NamedPerson> people_of(const WatchedRoom& room) {
  const auto snapshot = room.snapshot();
  std::vector<NamedPerson> people;
  for (const RoomPerson& person : snapshot->people)
    people.push_back({person, person.id == snapshot->self});
  return people;
}

const char* kind_of(const RoomMark& mark) {
  const auto found =
      std::ranges::find(kMarkKinds, mark.kind, &std::pair<MarkKind, const char*>::first);
  return found == kMarkKinds.end() ? "" : found->second;
}

py::array points_of(const RoomMark& mark) {
  const auto owner = std::make_shared<const std::vector<Eigen::Vector3f>>(mark.points_m);
  return array_of(*owner, owner);
}

std::vector<Eigen::Vector3f> read_points(const py::object& given) {
  const auto numbers = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!numbers || numbers.ndim() != 2 || numbers.shape(1) != 3) {
    PyErr_Clear();
    throw Failure(invalid_argument("points must be N x 3 numbers"));
  }
  std::vector<Eigen::Vector3f> points;
  for (py::ssize_t i = 0; i < numbers.shape(0); ++i)
    points.emplace_back(Eigen::Vector3f::Map(numbers.data(i, 0)));
  return points;
}

/// What `ask` answers, without the interpreter's lock.
template <class Ask>
auto answer_of(const WatchedRoom& room, Ask ask) {
  const auto subscriber = room.subscriber();
  return interruptible([&](const std::stop_token& stop) { return ask(*subscriber, stop); });
}

std::uint32_t leave(const WatchedRoom& room, const std::string& kind, const py::object& points,
                    const std::string& text) {
  const auto known = std::ranges::find(kMarkKinds, kind, [](const auto& k) { return k.second; });
  if (known == kMarkKinds.end())
    throw Failure(invalid_argument("kind must be note, sketch, distance or place"));
  RoomMark mark;
  mark.kind = known->first;
  mark.points_m = read_points(points);
  mark.text = text;
  return value_of(answer_of(room, [&](client::Subscriber& hub, const std::stop_token& stop) {
    return client::leave_mark(hub, mark, {client::kMarkPatience.time, stop});
  }));
}

void remove(const WatchedRoom& room, std::uint32_t id) {
  check(answer_of(room, [&](client::Subscriber& hub, const std::stop_token& stop) {
    return client::remove_mark(hub, id, {client::kMarkPatience.time, stop});
  }));
}

void send_pose(const WatchedRoom& room, const py::object& head, const py::object& left,
               const py::object& right) {
  PersonPose pose;
  pose.world_from_head = transform_of(head, "room_from_head");
  if (!left.is_none()) pose.world_from_left_hand = transform_of(left, "room_from_left_hand");
  if (!right.is_none()) pose.world_from_right_hand = transform_of(right, "room_from_right_hand");
  room.subscriber()->send_pose(pose);
}

py::object next_voice(WatchedRoom& room, std::optional<double> timeout_s) {
  using Steady = WatchedRoom::Steady;
  if (timeout_s && !(*timeout_s >= 0)) throw Failure(invalid_argument("timeout_s is negative"));
  constexpr double kLongest_s = 1e6;
  const auto until =
      Steady::now() + std::chrono::duration_cast<Steady::duration>(std::chrono::duration<double>(
                          std::min(timeout_s.value_or(kLongest_s), kLongest_s)));
  for (;;) {
    if (auto heard = room.listener.next()) return py::cast(*std::move(heard));
    const auto subscriber = room.subscriber();
    std::optional<client::HeardPacket> packet;
    {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Steady::now());
      const WithoutGil without;
      packet =
          subscriber->next_voice(std::clamp(left, std::chrono::milliseconds(0), kSignalPeriod));
    }
    check_signals();
    if (packet)
      room.listener.take(*std::move(packet));
    else if (const auto failure = subscriber->failure())
      throw Failure(*failure);
    else if (Steady::now() >= until)
      return py::none();
  }
}

void speak(WatchedRoom& room, const py::object& given) {
  const auto samples = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!samples || samples.ndim() != 1) {
    PyErr_Clear();
    throw Failure(invalid_argument("samples must be a row of numbers"));
  }
  const std::span sound(samples.data(), static_cast<std::size_t>(samples.size()));
  check(client::speak(*room.subscriber(), room.spoken, sound, SteadyClock().now()));
}

void pause_speaking(WatchedRoom& room) {
  client::pause_speaking(*room.subscriber(), room.spoken);
}

using Placed = std::tuple<py::array, double>;

template <class Wanted>
Placed placed_by(const WatchedRoom& room, const std::string& sensor, Wanted wanted) {
  const auto placed =
      value_of(answer_of(room, [&](client::Subscriber& hub, const std::stop_token& stop) {
        return client::place_sensor(hub, sensor, wanted, {client::kPriorPatience.time, stop});
      }));
  return {array_of(placed.world_from_depth), placed.expected_error_mm};
}

Placed place(const WatchedRoom& room, const std::string& sensor, const py::object& matrix) {
  const RigidTransform pose = transform_of(matrix, "room_from_sensor");
  return placed_by(room, sensor, [pose](const RigidTransform&) { return pose; });
}

Placed nudge(const WatchedRoom& room, const std::string& sensor,
             const std::array<double, 3>& shift_m, double turn_rad, double tilt_rad) {
  client::NudgeOptions by;
  by.shift_m = Eigen::Vector3d::Map(shift_m.data());
  by.turn_rad = turn_rad;
  by.tilt_rad = tilt_rad;
  check(client::check_nudge(by));
  return placed_by(room, sensor,
                   [by](const RigidTransform& pose) { return client::nudged(pose, by); });
}

void add_persons(py::module_& module) {
  py::class_<NamedPerson>(module, "Person", "A person in a room, at one moment.")
      .def_property_readonly("id", [](const NamedPerson& p) { return p.person.id.value; })
      .def_property_readonly("name", [](const NamedPerson& p) { return p.person.name; })
      .def_property_readonly(
          "color", [](const NamedPerson& p) { return color_of(p.person.color); },
          "Red, green, blue: the same for everybody.")
      .def_readonly("is_self", &NamedPerson::is_self)
      .def_property_readonly(
          "speaking", [](const NamedPerson& p) { return p.person.speaking; },
          "Known in rooms joined with hears=True, as is muted.")
      .def_property_readonly(
          "muted", [](const NamedPerson& p) { return p.person.muted; }, "By an admin.")
      .def_property_readonly(
          "room_from_head", [](const NamedPerson& p) { return head_of(p.person); },
          "4 x 4; the head's frame: x right, y up, z backwards. None: not known.")
      .def_property_readonly(
          "room_from_left_hand",
          [](const NamedPerson& p) { return part_of(p.person, &PersonPose::world_from_left_hand); })
      .def_property_readonly("room_from_right_hand", [](const NamedPerson& p) {
        return part_of(p.person, &PersonPose::world_from_right_hand);
      });
}

void add_marks(py::module_& module) {
  py::class_<RoomMark>(module, "Mark", "What somebody has left in a room for everybody.")
      .def_readonly("id", &RoomMark::id)
      .def_property_readonly("kind", &kind_of, "note, sketch, distance or place.")
      .def_property_readonly("points", &points_of, "N x 3, metres, in the room's frame.")
      .def_readonly("text", &RoomMark::text, "Words of a note, name of a place.")
      .def_readonly("author", &RoomMark::author)
      .def_property_readonly("color", [](const RoomMark& mark) { return color_of(mark.color); })
      .def_readonly("own", &RoomMark::own, "Whether this program may remove it.");
}

void add_voices(py::module_& module) {
  py::class_<VoiceListener::Heard>(module, "Voice", "20 ms of somebody's voice.")
      .def_property_readonly(
          "speaker", [](const VoiceListener::Heard& v) { return v.packet.speaker.value; },
          "A person's ID; of a sensor's microphone, a number that no person has.")
      .def_property_readonly(
          "sensor",
          [](const VoiceListener::Heard& v) {
            const auto sensor = client::sensor_of_speaker(v.packet.speaker);
            return sensor ? std::optional<int>(sensor->value) : std::nullopt;
          },
          "The number of the sensor whose microphone it is; None: a person speaks.")
      .def_property_readonly(
          "seq", [](const VoiceListener::Heard& v) { return v.packet.seq; },
          "Counts the speaker's packets.")
      .def_property_readonly(
          "ends", [](const VoiceListener::Heard& v) { return v.packet.ends; },
          "Whether the speaker pauses after it.")
      .def_property_readonly(
          "samples",
          [](const VoiceListener::Heard& v) {
            return py::array_t<float>(static_cast<py::ssize_t>(v.samples.size()), v.samples.data());
          },
          "960 samples at 48 kHz, -1 to 1.")
      .def_property_readonly(
          "opus",
          [](const VoiceListener::Heard& v) {
            return py::bytes(reinterpret_cast<const char*>(v.packet.opus.data()),  // NOLINT: bytes
                             v.packet.opus.size());
          },
          "As it came (RFC 6716); empty: lost on its way, and samples conceals that.");
}

}  // namespace

void add_people(py::module_& module, py::class_<WatchedRoom>& rooms) {
  add_persons(module);
  add_marks(module);
  add_voices(module);
  rooms.def_property_readonly("people", &people_of, "The people in the room, as Person.")
      .def_property_readonly(
          "marks", [](const WatchedRoom& room) { return *room.snapshot()->marks; },
          "What people have left in the room, as Mark, in the order in which they left it.")
      .def_property_readonly(
          "may_speak", [](const WatchedRoom& room) { return room.snapshot()->rights.may_speak; })
      .def_property_readonly(
          "may_mark", [](const WatchedRoom& room) { return room.snapshot()->rights.may_mark; })
      .def_property_readonly(
          "may_place", [](const WatchedRoom& room) { return room.snapshot()->rights.may_place; },
          "Whether place() and nudge() are allowed: with an admin's token.")
      .def("send_pose", &send_pose, "room_from_head"_a, "room_from_left_hand"_a = py::none(),
           "room_from_right_hand"_a = py::none(),
           "Shows you to the others, who see you there; 4 x 4, frames as in Person.")
      .def("leave_mark", &leave, "kind"_a, "points"_a, "text"_a = "", kLeaveMarkDoc)
      .def("remove_mark", &remove, "id"_a,
           "Removes a mark: one's own, or any with an admin's token. Else raises Error.")
      .def("next_voice", &next_voice, "timeout_s"_a = py::none(), kNextVoiceDoc)
      .def("speak", &speak, "samples"_a, kSpeakDoc)
      .def("pause_speaking", &pause_speaking, "Says what is left over, and that a pause follows.")
      .def("place", &place, "sensor"_a, "room_from_sensor"_a, kPlaceDoc)
      .def("nudge", &nudge, "sensor"_a, py::kw_only(), "shift"_a = std::array<double, 3>{0, 0, 0},
           "turn_rad"_a = 0.0, "tilt_rad"_a = 0.0, kNudgeDoc);
}

}  // namespace roomcast::python
