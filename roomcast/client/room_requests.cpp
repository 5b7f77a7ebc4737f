// SPDX-License-Identifier: Apache-2.0
#include "roomcast/client/room_requests.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

namespace roomcast::client {
namespace {

constexpr std::chrono::milliseconds kStopPeriod{50};

using Snapshot = std::shared_ptr<const RoomSnapshot>;

Error no_connection(const RoomSnapshot& room) {
  return unavailable(room.problem.empty() ? "there is no connection to the hub" : room.problem);
}

/// Returns the first answer that `look(snapshot)` gives, an optional.
template <class Answer, class Look>
Answer answered(const Subscriber& room, const Patience& patience, const std::string& silence,
                Look look) {
  const auto until = std::chrono::steady_clock::now() + patience.time;
  Snapshot now = room.snapshot();
  for (;;) {
    if (!now->connected) return no_connection(*now);
    if (std::optional<Answer> answer = look(*now)) return *std::move(answer);
    const auto left =
        std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
    if (left.count() <= 0 || patience.stop.stop_requested()) return unavailable(silence);
    now = room.wait_newer(now->revision, std::min(left, kStopPeriod));
  }
}

const RoomMark* mark_of(const RoomSnapshot& room, std::uint32_t id) {
  const auto found = std::ranges::find(*room.marks, id, &RoomMark::id);
  return found == room.marks->end() ? nullptr : &*found;
}

const RoomSensor* sensor_of(const RoomSnapshot& room, const std::string& name) {
  const auto found = std::ranges::find(room.sensors, name, &RoomSensor::name);
  return found == room.sensors.end() ? nullptr : &*found;
}

Error no_such_sensor(const std::string& name) {
  return {ErrorCode::kNotFound, "the room has no sensor \"" + name + "\""};
}

/// Why no pose can be proposed for this sensor; nothing: one can.
std::optional<Error> why_not_place(const RoomSnapshot& room, const std::string& name) {
  if (const Status may = check_may_place(room.rights); !may) return may.error();
  const RoomSensor* const sensor = sensor_of(room, name);
  if (sensor == nullptr) return no_such_sensor(name);
  if (sensor->pose.source == PoseSource::kGiven && !sensor->pose.is_moved())
    return unavailable("the sensor \"" + name +
                       "\" has supplied its pose, which therefore holds; start the sensor again "
                       "with another one, or without one");
  return std::nullopt;
}

}  // namespace

Result<std::uint32_t> leave_mark(Subscriber& room, const RoomMark& mark, const Patience& patience) {
  using Answer = Result<std::uint32_t>;
  auto message = message_from_mark(mark);
  if (!message) return message.error();
  const Snapshot before = room.snapshot();
  if (const Status may = check_may_mark(before->rights); before->connected && !may)
    return may.error();
  room.send_mark(*message);
  return answered<Answer>(room, patience, "the hub has not answered whether it keeps the mark",
                          [&](const RoomSnapshot& now) -> std::optional<Answer> {
                            if (now.mark_refusals != before->mark_refusals)
                              return unavailable(now.mark_refusal);
                            for (const RoomMark& left : *now.marks) {
                              if (left.own && left.kind == mark.kind && left.text == mark.text &&
                                  left.points_m == mark.points_m &&
                                  mark_of(*before, left.id) == nullptr)
                                return left.id;
                            }
                            return std::nullopt;
                          });
}

Status remove_mark(Subscriber& room, std::uint32_t mark, const Patience& patience) {
  const Snapshot before = room.snapshot();
  if (before->connected && mark_of(*before, mark) == nullptr)
    return Error{ErrorCode::kNotFound, "the room has no mark " + std::to_string(mark)};
  room.send_removal(std::array{mark});
  return answered<Status>(room, patience, "the hub has not answered whether it removes the mark",
                          [&](const RoomSnapshot& now) -> std::optional<Status> {
                            if (now.mark_refusals != before->mark_refusals)
                              return Status(unavailable(now.mark_refusal));
                            if (mark_of(now, mark) == nullptr) return Status();
                            return std::nullopt;
                          });
}

Result<PlacedSensor> place_sensor(
    Subscriber& room, const std::string& name,
    const std::function<RigidTransform(const RigidTransform&)>& wanted, const Patience& patience) {
  using Answer = Result<PlacedSensor>;
  std::optional<SensorPose> before;
  return answered<Answer>(
      room, patience,
      "the hub's aligner has not answered; check that the hub runs without --no-align",
      [&](const RoomSnapshot& now) -> std::optional<Answer> {
        if (!now.sensors_known) return std::nullopt;
        if (!before) {
          if (auto why = why_not_place(now, name)) return Answer(*std::move(why));
          const RoomSensor& sensor = *sensor_of(now, name);
          before = sensor.pose;
          room.send_prior(sensor.id, wanted(sensor.pose.world_from_depth));
          return std::nullopt;
        }
        const RoomSensor* const sensor = sensor_of(now, name);
        if (sensor == nullptr) return Answer(no_such_sensor(name));
        const SensorPose& pose = sensor->pose;
        if (pose.is_placed() && row_major_from_transform(pose.world_from_depth) !=
                                    row_major_from_transform(before->world_from_depth))
          return Answer(PlacedSensor{pose.world_from_depth, pose.expected_error_mm});
        if (pose.note != before->note) return Answer(unavailable(pose.note));
        return std::nullopt;
      });
}

}  // namespace roomcast::client
