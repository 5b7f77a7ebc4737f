// SPDX-License-Identifier: Apache-2.0
#include "roomcast/capi/roomcast.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "roomcast/capi/c_border.h"
#include "roomcast/capi/frames.h"
#include "roomcast/capi/received_sensor.h"
#include "roomcast/capi/room_points.h"
#include "roomcast/capi/viewer.h"
#include "roomcast/recording/recorder/recorder.h"

struct roomcast_recorder {
  std::unique_ptr<roomcast::recording::Recorder> recorder;
};

namespace {

using namespace roomcast;

using capi::copy_known_part;
using capi::guarded;
using capi::known_part;
using capi::say;
using capi::text;

nanoseconds unix_time(const roomcast_viewer& viewer, const client::RoomSnapshot& room,
                      const client::SensorPicture& picture) {
  return room.clock ? viewer.unix_clock.at(picture.capture_time, *room.clock)
                    : viewer.unix_clock.at(picture.received);
}

Result<std::optional<RigidTransform>> tracked(const double* row_major, const char* what) {
  if (row_major == nullptr) return std::optional<RigidTransform>();
  auto transform = transform_from_row_major(std::span(row_major, 16));
  if (transform) return std::optional(*transform);
  return Error{transform.error().code, std::string(what) + ": " + transform.error().message};
}

Result<client::PersonPose> person_pose(const roomcast_pose& given) {
  const auto head = tracked(given.world_from_head, "world_from_head");
  const auto left = tracked(given.world_from_left_hand, "world_from_left_hand");
  const auto right = tracked(given.world_from_right_hand, "world_from_right_hand");
  for (const auto* part : {&head, &left, &right}) {
    if (!*part) return part->error();
  }
  if (!*head) return Error{ErrorCode::kInvalidArgument, "world_from_head is NULL"};
  return client::PersonPose{.world_from_head = **head,
                            .world_from_left_hand = *left,
                            .world_from_right_hand = *right,
                            .pointer = {}};
}

int may(roomcast_viewer* viewer, Status (*check)(const client::ViewerRights&), char* error,
        std::size_t size) {
  return guarded(0, error, size, [&] {
    const Status allowed = check(viewer->subscriber->snapshot()->rights);
    if (!allowed) say(allowed.error().message, error, size);
    return allowed ? 1 : 0;
  });
}

using WallClock = std::chrono::steady_clock;

std::shared_ptr<const client::RoomSnapshot> wait_newer(roomcast_viewer& viewer,
                                                       WallClock::time_point until) {
  std::uint64_t revision = 0;
  {
    std::lock_guard lock(viewer.mutex);
    revision = viewer.last_revision;
  }
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - WallClock::now());
  return viewer.subscriber->wait_newer(revision, std::max(left, std::chrono::milliseconds(0)));
}

/// Null if `room` has no frame set newer than the last one returned.
roomcast_frames* new_frames(roomcast_viewer& viewer,
                            const std::shared_ptr<const client::RoomSnapshot>& room) {
  std::lock_guard lock(viewer.mutex);
  viewer.last_revision = std::max(viewer.last_revision, room->revision);
  if (!(room->newest_set > viewer.last_set)) return nullptr;
  viewer.last_set = room->newest_set;
  auto frames = std::make_unique<roomcast_frames>();
  frames->room = room;
  frames->sensors = capi::received_sensors(*room, viewer.rays);
  for (capi::ReceivedSensor& received : frames->sensors) {
    const client::SensorPicture& picture = *received.sensor->picture;
    received.stamp = {picture.seq, picture.capture_time.time_since_epoch().count(),
                      unix_time(viewer, *room, picture).count()};
  }
  return frames.release();
}

}  // namespace

extern "C" {

const char* roomcast_version(void) {
  return ROOMCAST_LIBRARY_VERSION;
}

roomcast_viewer* roomcast_connect(const roomcast_options* given, char* error, size_t error_size) {
  return guarded<roomcast_viewer*>(nullptr, error, error_size, [&]() -> roomcast_viewer* {
    const roomcast_options options = known_part(given);
    client::SubscriberOptions subscriber;
    subscriber.hub_url = text(options.hub);
    subscriber.room = text(options.room);
    subscriber.name = text(options.name);
    subscriber.credential = client::credential_of(text(options.token));
    subscriber.author_key = text(options.author_key);
    subscriber.hears = options.hears != 0;
    auto opened = client::Subscriber::open(std::move(subscriber));
    if (!opened) {
      say(opened.error().message, error, error_size);
      return nullptr;
    }
    auto viewer = std::make_unique<roomcast_viewer>();
    viewer->subscriber = std::move(*opened);
    return viewer.release();
  });
}

void roomcast_disconnect(roomcast_viewer* viewer) {
  delete viewer;
}

int roomcast_is_connected(roomcast_viewer* viewer, char* error, size_t error_size) {
  return guarded(0, error, error_size, [&] {
    const auto room = viewer->subscriber->snapshot();
    if (!room->connected) say(room->problem, error, error_size);
    return room->connected ? 1 : 0;
  });
}

int roomcast_may_record(roomcast_viewer* viewer, char* error, size_t error_size) {
  return may(viewer, client::check_may_record, error, error_size);
}

int roomcast_may_export(roomcast_viewer* viewer, char* error, size_t error_size) {
  return may(viewer, client::check_may_export, error, error_size);
}

roomcast_frames* roomcast_wait_frames(roomcast_viewer* viewer, int timeout_ms) {
  return guarded<roomcast_frames*>(nullptr, nullptr, 0, [&]() -> roomcast_frames* {
    const auto until = WallClock::now() + std::chrono::milliseconds(timeout_ms);
    for (;;) {
      const auto room = wait_newer(*viewer, until);
      if (roomcast_frames* frames = new_frames(*viewer, room)) return frames;
      if (WallClock::now() >= until || viewer->subscriber->failure()) return nullptr;
    }
  });
}

void roomcast_free_frames(roomcast_frames* frames) {
  delete frames;
}

size_t roomcast_sensor_count(const roomcast_frames* frames) {
  return frames->sensors.size();
}

size_t roomcast_room_sensor_count(const roomcast_frames* frames) {
  return static_cast<std::size_t>(
      std::ranges::count(frames->room->sensors, true, &client::RoomSensor::online));
}

int roomcast_get_sensor(const roomcast_frames* frames, size_t number, roomcast_sensor* sensor) {
  if (number >= frames->sensors.size()) return 0;
  copy_known_part(capi::describe(frames->sensors[number]), *sensor);
  return 1;
}

size_t roomcast_get_points(const roomcast_frames* frames, roomcast_point* points, size_t capacity) {
  return guarded<std::size_t>(0, nullptr, 0, [&] {
    return capi::write_points(frames->sensors, std::span(points, points == nullptr ? 0 : capacity));
  });
}

int roomcast_send_pose(roomcast_viewer* viewer, const roomcast_pose* given, char* error,
                       size_t error_size) {
  return guarded(0, error, error_size, [&] {
    const auto pose = person_pose(known_part(given));
    if (!pose) {
      say(pose.error().message, error, error_size);
      return 0;
    }
    viewer->subscriber->send_pose(*pose);
    return 1;
  });
}

roomcast_recorder* roomcast_record(const roomcast_options* given, const char* path, char* error,
                                   size_t error_size) {
  return guarded<roomcast_recorder*>(nullptr, error, error_size, [&]() -> roomcast_recorder* {
    const roomcast_options options = known_part(given);
    recording::RecorderOptions recorder;
    recorder.hub_url = text(options.hub);
    recorder.room = text(options.room);
    recorder.credential = client::credential_of(text(options.token));
    recorder.path = text(path);
    auto opened = recording::Recorder::open(std::move(recorder));
    if (!opened) {
      say(opened.error().message, error, error_size);
      return nullptr;
    }
    auto out = std::make_unique<roomcast_recorder>();
    out->recorder = std::move(*opened);
    return out.release();
  });
}

int roomcast_is_recording(roomcast_recorder* recorder, char* error, size_t error_size) {
  return guarded(0, error, error_size, [&] {
    const auto failure = recorder->recorder->failure();
    if (failure) say(failure->message, error, error_size);
    return failure ? 0 : 1;
  });
}

int roomcast_stop_recording(roomcast_recorder* recorder, char* error, size_t error_size) {
  const std::unique_ptr<roomcast_recorder> ends(recorder);
  return guarded(0, error, error_size, [&] {
    const Status status = ends->recorder->finish();
    if (!status) say(status.error().message, error, error_size);
    return status ? 1 : 0;
  });
}

}  // extern "C"
