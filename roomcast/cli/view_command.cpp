// SPDX-License-Identifier: Apache-2.0
// roomcast view: the room from a program. For now a picture drawn without a window.
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "roomcast/cli/command.h"
#include "roomcast/cli/frame_log.h"
#include "roomcast/cli/render_mode_option.h"
#include "roomcast/cli/status_line.h"
#include "roomcast/cli/stop_on_signal.h"
#include "roomcast/client/subscriber.h"
#include "roomcast/render/gl_context.h"
#include "roomcast/source/image_file.h"
#include "roomcast/viewer/room_view.h"

namespace roomcast::cli {
namespace {

using namespace std::chrono_literals;
using RoomPtr = std::shared_ptr<const RoomSnapshot>;
constexpr auto kPicturesWithin = 10s;

struct ViewOptions {
  SubscriberOptions subscriber;
  bool headless = false;
  std::string png;
  std::vector<double> at, look;
  std::vector<int> size = {1280, 720};
  double fov_deg = 60;
  double seconds = 0;
  RenderMode mode = RenderMode::kBlend;
  bool json = false;
};

/// Sensors that are online and have not sent a picture yet.
std::string missing_sensors(const RoomSnapshot& room) {
  std::string names;
  for (const auto& sensor : room.sensors) {
    if (sensor.online && !sensor.picture) names += (names.empty() ? "" : ", ") + sensor.name;
  }
  return names;
}

/// Connected (else the pictures are old), and all sensors that are there can be seen.
bool can_be_drawn(const RoomSnapshot& room) {
  const auto is_seen = [](const RoomSensor& sensor) { return sensor.online && sensor.picture; };
  return room.connected && std::ranges::any_of(room.sensors, is_seen) &&
         missing_sensors(room).empty();
}

/// Why there is nothing to draw yet.
Error still_waiting(const RoomSnapshot& room) {
  if (!room.connected) return {ErrorCode::kUnavailable, room.problem};
  const std::string missing = missing_sensors(room);
  if (!missing.empty()) {
    return {ErrorCode::kUnavailable, fmt::format("no picture came from {} within {} s", missing,
                                                 std::chrono::seconds(kPicturesWithin).count())};
  }
  return {ErrorCode::kUnavailable, room.sensors.empty()
                                       ? "no sensor has joined this room; nothing was drawn"
                                       : "all sensors have left this room; nothing was drawn"};
}

/// The room, once every sensor that is online has sent a picture.
Result<RoomPtr> wait_for_pictures(const Subscriber& viewer, const std::stop_token& stop) {
  const auto give_up = std::chrono::steady_clock::now() + kPicturesWithin;
  RoomPtr room = viewer.snapshot();
  while (!can_be_drawn(*room)) {
    if (auto failure = viewer.failure()) return *failure;
    if (stop.stop_requested())
      return Error{ErrorCode::kClosed, "interrupted before there was a picture"};
    if (std::chrono::steady_clock::now() > give_up) return still_waiting(*room);
    room = viewer.wait_newer(room->revision, 100ms);
  }
  return room;
}

void watch(const Subscriber& viewer, double seconds, const std::stop_token& stop) {
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

ViewCamera camera_for(const ViewOptions& options, const RoomSnapshot& room) {
  ViewCamera camera;
  camera.width = options.size[0];
  camera.height = options.size[1];
  camera.vertical_fov_rad = options.fov_deg * 3.14159265358979323846 / 180;
  camera.world_from_view = world_from_start_view(room);
  if (options.at.empty()) return camera;
  const Eigen::Vector3d eye(options.at[0], options.at[1], options.at[2]);
  const Eigen::Vector3d forward = camera.world_from_view.rotation * Eigen::Vector3d(0, 0, -1);
  const Eigen::Vector3d target =
      options.look.empty() ? Eigen::Vector3d(eye + forward)
                           : Eigen::Vector3d(options.look[0], options.look[1], options.look[2]);
  camera.world_from_view = world_from_view_looking_at(eye, target);
  return camera;
}

Result<ColorImage> draw(const ViewOptions& options, const RoomSnapshot& room) {
  const ViewCamera camera = camera_for(options, room);
  if (auto status = camera.check(); !status) return status.error();
  auto context = EglContext::create();
  if (!context) return context.error();
  auto target = OffscreenTarget::create(camera.width, camera.height);
  if (!target) return target.error();
  auto view = RoomView::create();
  if (!view) return view.error();
  if (auto status = view->show(room); !status) return status.error();
  if (auto status = view->draw(camera, *target, options.mode); !status) return status.error();
  return target->read_color();
}

void print_json(const ViewOptions& options, const RoomSnapshot& room) {
  nlohmann::json report = {
      {"png", options.png}, {"room", room.room}, {"set_id", room.newest_set.value}};
  for (const auto& sensor : room.sensors) {
    if (!sensor.online || !sensor.picture) continue;
    report["sensors"].push_back(
        {{"id", sensor.id.value},
         {"name", sensor.name},
         {"placed", sensor.placed},
         {"seq", sensor.picture->seq},
         {"capture_ns", sensor.picture->capture_time.time_since_epoch().count()},
         {"depth_crc32", depth_crc32(sensor.picture->frame.depth_mm)}});
  }
  fmt::print("{}\n", report.dump(1));
}

Status run_view(const ViewOptions& options) {
  if (!options.headless || options.png.empty()) {
    return Error{ErrorCode::kInvalidArgument,
                 "there is no window yet: use --headless --png FILE, or open the hub's address in "
                 "a browser"};
  }
  StopOnSignal stop;
  auto viewer = Subscriber::open(options.subscriber);
  if (!viewer) return viewer.error();
  auto room = wait_for_pictures(**viewer, stop.token());
  if (room && options.seconds > 0) {
    watch(**viewer, options.seconds, stop.token());
    room = wait_for_pictures(**viewer, stop.token());  // sensors may have left, or the hub
  }
  if (!room) return room.error();
  const auto picture = draw(options, **room);
  if (!picture) return picture.error();
  if (auto status = write_color_png(options.png, *picture); !status) return status;
  if (options.json) print_json(options, **room);
  return {};
}

}  // namespace

void add_view_command(CLI::App& app, Command& chosen) {
  auto options = std::make_shared<ViewOptions>();
  CLI::App* command =
      app.add_subcommand("view", "See a room from a program: a picture, drawn without a window");
  command->add_option("--hub", options->subscriber.hub_url, "ws://HOST:PORT")->required();
  command->add_option("--room", options->subscriber.room, "The room (default: the hub's only one)");
  command->add_option("--name", options->subscriber.name, "Shown to others");
  command->add_flag("--headless", options->headless, "Draw without a window");
  command->add_option("--png", options->png, "Write the picture here");
  command
      ->add_option("--at", options->at,
                   "Where to stand: x,y,z in metres (default: where the hub puts a viewer)")
      ->delimiter(',')
      ->expected(3);
  command->add_option("--look", options->look, "What to look at: x,y,z in metres")
      ->delimiter(',')
      ->expected(3)
      ->needs("--at");
  command->add_option("--size", options->size, "Width,height in pixels")
      ->delimiter(',')
      ->expected(2)
      ->capture_default_str();
  command->add_option("--fov", options->fov_deg, "Vertical field of view, degrees")
      ->check(CLI::Range(1.0, 170.0))
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "Receive this long before drawing")
      ->check(CLI::NonNegativeNumber);
  add_mode_option(*command, "--mode", options->mode);
  command->add_flag("--json", options->json, "Report which frames were drawn");
  command->footer(
      "Waits up to 10 s until every sensor that is in the room has sent a picture. When there is\n"
      "none it draws nothing, says so and ends with 1.\n"
      "Example:\n  roomcast view --hub ws://127.0.0.1:7600 --headless --png room.png --at 3,1.6,2 "
      "--look 0,1,0");
  command->callback(
      [options, &chosen] { chosen = [options] { return finish("view", run_view(*options)); }; });
}

}  // namespace roomcast::cli
