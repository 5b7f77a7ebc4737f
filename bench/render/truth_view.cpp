// SPDX-License-Identifier: Apache-2.0
#include "bench/render/truth_view.h"

#include <chrono>
#include <cmath>
#include <fstream>
#include <string>

#include <nlohmann/json.hpp>

#include "roomcast/io/image_file.h"

namespace roomcast::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TruthViewEntry entry_from_json(const json& file, const json& view,
                               const recording::RigDescription& rig, const fs::path& folder) {
  TruthViewEntry entry;
  entry.view = view.at("view");
  entry.instant = view.at("instant");
  const std::chrono::duration<double> time(view.at("true_time_s").get<double>());
  entry.time = RoomTime(std::chrono::round<nanoseconds>(time));
  const std::vector<double> pose = view.at("world_from_view");
  entry.camera.world_from_view =
      transform_from_row_major(pose).value() * render::optical_from_view();
  entry.camera.width = file.at("width");
  entry.camera.height = file.at("height");
  entry.camera.vertical_fov_rad =
      2 * std::atan(0.5 * entry.camera.height / file.at("fy").get<double>());
  entry.color = folder / view.at("color").get<std::string>();
  entry.depth = folder / view.at("depth").get<std::string>();
  entry.seen = folder / view.at("seen").get<std::string>();
  for (const recording::RigSensorEntry& sensor : rig.sensors) {
    entry.frames.push_back(view.at("frame").at(sensor.id).get<std::uint64_t>());
  }
  return entry;
}

}  // namespace

ViewPoints::ViewPoints(const render::ViewCamera& camera)
    : world_from_optical_(camera.world_from_view * render::optical_from_view().inverse()),
      focal_px_(render::focal_length_px(camera)),
      middle_px_(0.5 * (camera.width - 1), 0.5 * (camera.height - 1)) {}

Eigen::Vector3d ViewPoints::at(int x, int y, double depth_m) const {
  const Eigen::Vector2d slope = (Eigen::Vector2d(x, y) - middle_px_) / focal_px_;
  return world_from_optical_ * Eigen::Vector3d(slope.x() * depth_m, slope.y() * depth_m, depth_m);
}

Result<TruthViews> read_truth_views(const fs::path& rig_folder) {
  const fs::path path = rig_folder / "truth" / "views.json";
  std::ifstream stream(path);
  if (!stream) {
    return Error{ErrorCode::kNotFound, "there are no true views to compare with: " + path.string() +
                                           " is missing (roomcast simulate --views writes it)"};
  }
  auto rig = recording::read_rig_json(rig_folder / "rig.json");
  if (!rig) return rig.error();
  TruthViews views{*std::move(rig), {}};
  try {
    const json file = json::parse(stream);
    for (const json& view : file.at("views")) {
      views.entries.push_back(entry_from_json(file, view, views.rig, path.parent_path()));
    }
  } catch (const json::exception& e) {
    return Error{ErrorCode::kMalformed, path.string() + ": " + e.what()};
  }
  return views;
}

Result<TruthView> load(const TruthViewEntry& entry) {
  const io::ImageSize size{entry.camera.width, entry.camera.height};
  io::ImageFileReader reader;
  TruthView view;
  if (auto status = reader.read_color(entry.color, size, view.color); !status) {
    return status.error();
  }
  if (auto status = reader.read_depth(entry.depth, size, view.depth_mm); !status) {
    return status.error();
  }
  if (auto status = reader.read_mask(entry.seen, size, view.seen); !status) return status.error();
  return view;
}

}  // namespace roomcast::bench
