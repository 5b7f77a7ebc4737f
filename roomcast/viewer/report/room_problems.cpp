// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/report/room_problems.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace roomcast::viewer {
namespace {

using Severity = RoomProblem::Severity;
constexpr std::string_view kEnds = ".?!";
using Seconds = std::chrono::duration<double>;

/// Sentences from elsewhere may end with a question, or with the end of a line.
std::string with_full_stop(std::string sentence) {
  sentence.erase(sentence.find_last_not_of(" \t\r\n") + 1);
  const bool has_end = !sentence.empty() && kEnds.find(sentence.back()) != kEnds.npos;
  return has_end ? sentence : sentence + '.';
}

RoomProblem lost_hub(const client::RoomSnapshot& room) {
  const std::string why = room.problem.empty() ? "there is no connection to the hub" : room.problem;
  return {Severity::kError, "hub",
          "The hub is lost: " + with_full_stop(why) +
              " The last pictures are shown; it is tried again."};
}

bool is_silent(const client::RoomSensor& sensor, HostTime now) {
  if (!sensor.picture || sensor.is_paused || sensor.is_held_back) return false;
  const Seconds three_frames(sensor.fps > 0 ? 3 / sensor.fps : 0);
  const Seconds patience = sensor.is_small ? kSilenceOnSlowLine : kSilence;
  return Seconds(now - sensor.picture->received) > std::max(patience, three_frames);
}

std::optional<RoomProblem> problem_of(const client::RoomSensor& sensor, HostTime now) {
  const std::string name = "Sensor " + sensor.name;
  if (!sensor.online) return RoomProblem{Severity::kNotice, sensor.name, name + " is gone."};
  if (is_silent(sensor, now)) {
    const auto silence_s = std::lround(Seconds(now - sensor.picture->received).count());
    return RoomProblem{Severity::kError, sensor.name,
                       name + " has been silent for " + std::to_string(silence_s) + " s."};
  }
  if (!sensor.picture)
    return RoomProblem{Severity::kNotice, sensor.name, name + " has not sent a picture yet."};
  if (sensor.pose.is_moved())
    return RoomProblem{Severity::kNotice, sensor.name,
                       name + " was moved: it is shown where it was until it is aligned again."};
  if (sensor.pose.state == PoseState::kUnverified)
    return RoomProblem{Severity::kNotice, sensor.name,
                       name + " is shown at its stored pose, which has not been confirmed yet."};
  if (sensor.pose.is_placed()) return std::nullopt;
  const std::string why = sensor.pose.note.empty() ? "." : ": " + with_full_stop(sensor.pose.note);
  return RoomProblem{Severity::kNotice, sensor.name,
                     name + " is not placed yet" + why + " It is shown at a provisional place."};
}

/// Of this viewer.
std::optional<RoomProblem> slow_line(const client::RoomSnapshot& room) {
  std::string held_back;
  bool is_coarse = false;
  for (const client::RoomSensor& sensor : room.sensors) {
    if (!sensor.online || sensor.is_paused) continue;
    is_coarse |= sensor.is_small;
    if (sensor.is_held_back) held_back += (held_back.empty() ? "" : ", ") + sensor.name;
  }
  if (!held_back.empty())
    return RoomProblem{
        Severity::kNotice, "room",
        "Your line is too slow for all sensors: now and then only comes a picture of " + held_back +
            "."};
  if (!is_coarse) return std::nullopt;
  return RoomProblem{Severity::kNotice, "room",
                     "Your line is slow, so some sensors send coarser pictures and fewer of them."};
}

}  // namespace

std::vector<RoomProblem> room_problems(const client::RoomSnapshot& room, HostTime now) {
  if (!room.connected) return {lost_hub(room)};
  if (room.sensors.empty()) return {{Severity::kNotice, "room", "No sensor is in the room yet."}};
  if (std::ranges::none_of(room.sensors, &client::RoomSensor::online))
    return {{Severity::kError, "room", "All sensors are gone."}};
  std::vector<RoomProblem> problems;
  for (const client::RoomSensor& sensor : room.sensors) {
    if (auto problem = problem_of(sensor, now)) problems.push_back(std::move(*problem));
  }
  if (auto slow = slow_line(room)) problems.push_back(std::move(*slow));
  std::ranges::stable_sort(problems, {}, &RoomProblem::severity);
  return problems;
}

}  // namespace roomcast::viewer
