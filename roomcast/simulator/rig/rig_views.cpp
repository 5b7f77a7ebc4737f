// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/rig/rig_views.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>

#include <nlohmann/json.hpp>

#include "roomcast/io/file_bytes.h"
#include "roomcast/io/image_file.h"
#include "roomcast/simulator/free_view.h"

namespace roomcast::simulator {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A field of view of 90 degrees, similar to a person's.
CameraIntrinsics view_lens(int side_px) {
  CameraIntrinsics lens;
  lens.width = lens.height = side_px;
  lens.fx = lens.fy = 0.5 * side_px;
  lens.cx = lens.cy = 0.5 * side_px - 0.5;
  return lens;
}

double seconds(nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

/// The recorded (not lost) frame of a sensor that is nearest in time.
std::uint64_t nearest_frame(const simulator::FrameClock& clock, nanoseconds time, int frames) {
  std::uint64_t best = 0;
  for (std::uint64_t frame = 1; frame < static_cast<std::uint64_t>(frames); ++frame) {
    if (clock.is_lost(frame)) continue;
    if (std::abs((clock.true_time(frame) - time).count()) <
        std::abs((clock.true_time(best) - time).count()))
      best = frame;
  }
  return best;
}

/// One instant: the moving things, and the sensors' clean depth.
struct Instant {
  nanoseconds time;
  simulator::MovingThings things;
  std::vector<DepthImage> sensor_depths;
};

std::vector<Instant> instants_of(const SimulatedRoom& room,
                                 std::span<const SimulatedSensor* const> sensors,
                                 const simulator::FrameClock& clock,
                                 const RigViewsOptions& options) {
  std::vector<Instant> instants;
  for (const int third : {1, 2}) {
    if (options.frames < 3 && third == 2) break;
    const auto frame = static_cast<std::uint64_t>(third * options.frames / 3);
    Instant instant{
        clock.true_time(frame), simulator::MovingThings(room.room(), options.speed), {}};
    instant.things.move_to(instant.time);
    for (const SimulatedSensor* sensor : sensors) {
      auto moment = sensor->make_moment();
      sensor->look(instant.time, moment);
      instant.sensor_depths.push_back(sensor->clean_depth_mm(moment));
    }
    instants.push_back(std::move(instant));
  }
  return instants;
}

json heading(const CameraIntrinsics& lens) {
  return {{"width", lens.width},
          {"height", lens.height},
          {"fx", lens.fx},
          {"fy", lens.fy},
          {"cx", lens.cx},
          {"cy", lens.cy},
          {"depth_scale_to_metre", 0.001},
          {"invalid_depth", json::array({0})},
          {"seen",
           "bit i = sensor s<i> sees that surface point at that instant: inside its depth picture "
           "and its range, at most 12 mm behind the farthest of the four depth pixels about it"},
          {"color_note",
           "no noise, no sensor gain; what each sensor's colour was multiplied by is in "
           "s<i>/gains.txt"},
          {"views", json::array()}};
}

json entry(int view, int number, const Instant& instant, const RigidTransform& world_from_view,
           std::span<const simulator::FrameClock> clocks, int frames) {
  const std::string name = "view_" + std::to_string(view) + "_t" + std::to_string(number);
  json nearest = json::object(), difference = json::object();
  for (std::size_t s = 0; s < clocks.size(); ++s) {
    const auto frame = nearest_frame(clocks[s], instant.time, frames);
    nearest["s" + std::to_string(s)] = frame;
    difference["s" + std::to_string(s)] = seconds(clocks[s].true_time(frame) - instant.time);
  }
  return {{"view", view},
          {"instant", number},
          {"color", name + ".png"},
          {"depth", name + "_depth.png"},
          {"seen", name + "_seen.png"},
          {"world_from_view", row_major_from_transform(world_from_view)},
          {"true_time_s", seconds(instant.time)},
          {"frame", nearest},
          {"frame_minus_view_s", difference}};
}

Status write_pictures(const fs::path& folder, const json& names, const FreeView& view,
                      const MaskImage& seen) {
  const auto path = [&](const char* which) { return folder / names[which].get<std::string>(); };
  if (Status written = io::write_color_png(path("color"), view.color()); !written) return written;
  if (Status written = io::write_depth_png(path("depth"), view.depth_mm()); !written)
    return written;
  return io::write_mask_png(path("seen"), seen);
}

}  // namespace

Status write_rig_views(const fs::path& folder, const SimulatedRoom& room,
                       std::span<const SimulatedSensor* const> sensors,
                       std::span<const simulator::FrameClock> clocks,
                       const RigViewsOptions& options,
                       const std::function<void(int done, int total)>& progress) {
  const CameraIntrinsics lens = view_lens(options.side_px);
  const auto places = free_viewpoints(room, sensors, options.count, options.seed);
  const auto instants = instants_of(room, sensors, clocks[0], options);
  const int total = static_cast<int>(places.size() * instants.size());
  json description = heading(lens);
  int done = 0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    if (progress) progress(done, total);
    FreeView view(room, lens, places[v], options.workers);
    for (std::size_t t = 0; t < instants.size(); ++t) {
      if (options.workers.stop.stop_requested())
        return Error{ErrorCode::kClosed, "stopped; the free views are incomplete"};
      view.look(instants[t].things);
      const json names = entry(static_cast<int>(v), static_cast<int>(t), instants[t], places[v],
                               clocks, options.frames);
      const MaskImage seen = view.seen_by(sensors, instants[t].sensor_depths);
      if (Status written = write_pictures(folder, names, view, seen); !written) return written;
      description["views"].push_back(names);
      if (progress) progress(++done, total);
    }
  }
  return io::write_file(folder / "views.json", description.dump(1) + "\n");
}

}  // namespace roomcast::simulator
