// SPDX-License-Identifier: Apache-2.0
// roomcast view --headless: draws a picture of the room without a window.
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/print.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/cli/view_options.h"
#include "roomcast/client/model/model_follower.h"
#include "roomcast/io/image_file.h"
#include "roomcast/render/gl/gl_context.h"
#include "roomcast/sensor/frame_log.h"
#include "roomcast/viewer/view/room_view.h"

namespace roomcast::cli {
namespace {

using namespace std::chrono_literals;
using RoomPtr = std::shared_ptr<const client::RoomSnapshot>;
constexpr auto kPicturesWithin = 10s;

/// Names of sensors that are online and have not sent a picture yet.
std::string missing_sensors(const client::RoomSnapshot& room) {
  std::string names;
  for (const auto& sensor : room.sensors) {
    if (sensor.online && !sensor.picture) names += (names.empty() ? "" : ", ") + sensor.name;
  }
  return names;
}

/// True when connected (else the pictures are old) and a sensor that is online can be drawn.
bool can_be_drawn(const client::RoomSnapshot& room) {
  const auto is_seen = [](const client::RoomSensor& sensor) {
    return sensor.online && sensor.picture;
  };
  return room.connected && std::ranges::any_of(room.sensors, is_seen);
}

std::string no_picture_came(const std::string& missing) {
  return fmt::format("no picture came from {} within {} s", missing,
                     std::chrono::seconds(kPicturesWithin).count());
}

/// The reason why nothing can be drawn yet.
Error still_waiting(const client::RoomSnapshot& room) {
  if (!room.connected) return {ErrorCode::kUnavailable, room.problem};
  const std::string missing = missing_sensors(room);
  if (!missing.empty()) {
    return {ErrorCode::kUnavailable, no_picture_came(missing)};
  }
  return {ErrorCode::kUnavailable, room.sensors.empty()
                                       ? "no sensor has joined this room; nothing was drawn"
                                       : "all sensors have left this room; nothing was drawn"};
}

/// Waits until every online sensor has sent a picture and returns the room. A sensor that sends
/// none within the time, or only what cannot be decoded, does not keep the others from being drawn.
Result<RoomPtr> wait_for_pictures(const client::Subscriber& viewer, const std::stop_token& stop) {
  const auto give_up = std::chrono::steady_clock::now() + kPicturesWithin;
  RoomPtr room = viewer.snapshot();
  while (!can_be_drawn(*room) || !missing_sensors(*room).empty()) {
    if (auto failure = viewer.failure()) return *failure;
    if (stop.stop_requested())
      return Error{ErrorCode::kClosed, "interrupted before there was a picture"};
    if (std::chrono::steady_clock::now() > give_up) {
      if (!can_be_drawn(*room)) return still_waiting(*room);
      print_err("roomcast view: {}; the others are drawn\n",
                no_picture_came(missing_sensors(*room)));
      return room;
    }
    room = viewer.wait_newer(room->revision, 100ms);
  }
  return room;
}

void watch(const client::Subscriber& viewer, double seconds, const std::stop_token& stop) {
  StatusLine line;
  const auto begin = std::chrono::steady_clock::now();
  const auto first_sets = viewer.snapshot()->sets_received;
  for (;;) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
    if (elapsed.count() >= seconds || stop.stop_requested()) return;
    std::this_thread::sleep_for(100ms);
    line.show(fmt::format("{} frame sets in {:.1f} s",
                          viewer.snapshot()->sets_received - first_sets, elapsed.count()));
  }
}

render::ViewCamera camera_for(const ViewOptions& options, const client::RoomSnapshot& room) {
  const RigidTransform start = viewer::world_from_start_view(room);
  render::ViewCamera camera;
  camera.width = options.size[0];
  camera.height = options.size[1];
  camera.vertical_fov_rad = options.fov_rad();
  camera.world_from_view = options.world_from_view(start).value_or(start);
  return camera;
}

/// Of the modes that show it. A room need not have a model, but to be seen without its sensors.
Status take_model(const ViewOptions& options, const client::RoomSnapshot& room,
                  viewer::RoomView& view) {
  const bool is_alone = options.mode == render::RenderMode::kStill;
  if (!is_alone && options.mode != render::RenderMode::kBlend) return {};
  const auto model = client::fetch_model(
      {options.subscriber.hub_url, options.subscriber.credential.token}, room.room, 0, {});
  if (model && *model) return view.take_model(**model);
  if (!is_alone) return {};
  if (!model) return model.error();
  return Error{ErrorCode::kUnavailable,
               "the hub has no model of this room yet; it makes one while somebody watches"};
}

Result<ColorImage> draw(const ViewOptions& options, const client::RoomSnapshot& room) {
  const render::ViewCamera camera = camera_for(options, room);
  if (auto status = camera.check(); !status) return status.error();
  auto context = render::EglContext::create();
  if (!context) return context.error();
  auto target = render::OffscreenTarget::create(camera.width, camera.height);
  if (!target) return target.error();
  auto view = viewer::RoomView::create();
  if (!view) return view.error();
  if (auto status = view->show(room); !status) return status.error();
  if (auto status = take_model(options, room, *view); !status) return status.error();
  if (auto status = view->draw(camera, *target, options.mode); !status) return status.error();
  return target->read_color();
}

void print_json(const ViewOptions& options, const client::RoomSnapshot& room) {
  nlohmann::json report = {
      {"png", options.png}, {"room", room.room}, {"set_id", room.newest_set.value}};
  for (const auto& sensor : room.sensors) {
    if (!sensor.online || !sensor.picture) continue;
    report["sensors"].push_back(
        {{"id", sensor.id.value},
         {"name", sensor.name},
         {"placed", sensor.pose.is_placed()},
         {"seq", sensor.picture->seq},
         {"capture_ns", sensor.picture->capture_time.time_since_epoch().count()},
         {"depth_crc32", sensor::depth_crc32(sensor.picture->frame.depth_mm)}});
  }
  print_out("{}\n", report.dump(1));
}

}  // namespace

Status view_without_window(const ViewOptions& options) {
  StopOnSignal stop;
  client::SubscriberOptions subscriber = options.subscriber;
  subscriber.stop = stop.token();
  auto viewer = client::Subscriber::open(std::move(subscriber));
  if (!viewer) return viewer.error();
  if (auto may = client::check_may_record((*viewer)->snapshot()->rights); !may) return may;
  // The model is also there without any sensor.
  const bool is_model_alone = options.mode == render::RenderMode::kStill;
  auto room = is_model_alone ? Result<RoomPtr>((*viewer)->snapshot())
                             : wait_for_pictures(**viewer, stop.token());
  if (room && options.seconds > 0) {
    watch(**viewer, options.seconds, stop.token());
    // Meanwhile sensors or the hub may have disconnected.
    if (!is_model_alone) room = wait_for_pictures(**viewer, stop.token());
  }
  if (!room) return room.error();
  const auto picture = draw(options, **room);
  if (!picture) return picture.error();
  if (auto status = io::write_color_png(options.png, *picture); !status) return status;
  if (options.json) print_json(options, **room);
  return {};
}

}  // namespace roomcast::cli
