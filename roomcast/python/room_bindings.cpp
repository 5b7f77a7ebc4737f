// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "roomcast/client/subscriber.h"
#include "roomcast/python/bindings.h"
#include "roomcast/python/errors.h"
#include "roomcast/python/watched_room.h"

namespace roomcast::python {
namespace {

namespace py = pybind11;
using namespace py::literals;
constexpr const char* kRoomDoc =
    "A live room. Iterating gives its newest FrameSet, again and again, each once: a\n"
    "program that is slower than the room misses sets, and delay does not grow. A broken\n"
    "connection is taken up again; where it has ended for good, Error says why. close() by\n"
    "another thread ends a loop.";
constexpr const char* kWatchDoc =
    "Joins a room as a viewer and waits for the hub's answer.\n\n"
    "url: 'ws://host:port', or 'wss://host:port#sha256=...'.\n"
    "token: where the room asks for one; or a one-time code. room: the name of the room,\n"
    "where the hub has several. name: shown to the others in the room.\n"
    "hears: gets people's voices. author_key: a secret of yours, by which the marks that you\n"
    "leave are yours later, too.\n"
    "Raises Error if there is no hub, or if it refuses.";
constexpr const char* kNewestDoc =
    "The newest FrameSet, once there is one newer than the last that was given; None after\n"
    "timeout_s (None: waits as long as it takes). Returns as soon as one sensor has a new\n"
    "frame: just after joining, see FrameSet.complete.";

std::unique_ptr<WatchedRoom> watch(const std::string& url, const std::string& token,
                                   const std::string& room, const std::string& name, bool hears,
                                   const std::string& author_key) {
  client::SubscriberOptions options;
  options.hub_url = url;
  options.room = room;
  options.name = name;
  options.hears = hears;
  options.author_key = author_key;
  options.credential = client::credential_of(token);
  return std::make_unique<WatchedRoom>(value_of(interruptible([&](const std::stop_token& stop) {
    options.stop = stop;
    return client::Subscriber::open(std::move(options));
  })));
}

constexpr double kLongestTimeout_s = 1e6;

py::object newest(WatchedRoom& room, std::optional<double> timeout_s) {
  if (timeout_s && !(*timeout_s >= 0)) throw Failure(invalid_argument("timeout_s is negative"));
  const auto timeout = std::chrono::duration<double>(
      std::min(timeout_s.value_or(kLongestTimeout_s), kLongestTimeout_s));
  auto set = room.wait_newer(WatchedRoom::Steady::now() +
                             std::chrono::duration_cast<WatchedRoom::Steady::duration>(timeout));
  (void)room.snapshot();  // throws where the room is closed
  return py::cast(std::move(set));
}

std::shared_ptr<RoomSet> next_live_set(WatchedRoom& room) {
  for (;;) {
    if (room.is_closed()) throw py::stop_iteration();
    if (auto set = room.wait_newer(WatchedRoom::Steady::now() + std::chrono::hours(1))) return set;
  }
}

py::object problem_of(const WatchedRoom& room) {
  const auto snapshot = room.snapshot();
  if (snapshot->connected) return py::none();
  return py::str(snapshot->problem);
}

}  // namespace

void add_rooms(py::module_& module) {
  py::class_<WatchedRoom> rooms(module, "Room", kRoomDoc);
  add_people(module, rooms);
  rooms.def("__iter__", [](const py::object& room) { return room; })
      .def("__next__", &next_live_set)
      .def("newest", &newest, "timeout_s"_a = py::none(), kNewestDoc)
      .def("__enter__", [](const py::object& room) { return room; })
      .def("__exit__", [](WatchedRoom& room, const py::args&) { room.close(); })
      .def("close", &WatchedRoom::close,
           "Leaves the room. Frame sets and arrays that were received stay valid.")
      .def_property_readonly(
          "name", [](const WatchedRoom& room) { return room.snapshot()->room; }, "Of the room.")
      .def_property_readonly(
          "sensors",
          [](const WatchedRoom& room) { return recording::sensors_of(*room.snapshot()); },
          "The sensors that the room knows, as SensorInfo; not all of them need be sending.")
      .def_property_readonly("problem", &problem_of,
                             "Why there is no connection at the moment; None while there is one.")
      .def_property_readonly(
          "may_record", [](const WatchedRoom& room) { return room.snapshot()->rights.may_record; },
          "Whether the room's owner lets viewers save its pictures.")
      .def_property_readonly(
          "may_export", [](const WatchedRoom& room) { return room.snapshot()->rights.may_export; },
          "Whether the room's owner lets viewers write files for other programs.");
  module.def("watch", &watch, "url"_a, py::kw_only(), "token"_a = "", "room"_a = "",
             "name"_a = "Python", "hears"_a = false, "author_key"_a = "", kWatchDoc);
}

}  // namespace roomcast::python
