// SPDX-License-Identifier: Apache-2.0
#include "bench/model/still_truth.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include "bench/render/truth_view.h"
#include "roomcast/io/camera_json.h"
#include "roomcast/io/image_file.h"

namespace roomcast::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxTruthFrames = 25;
constexpr int kSameTruth_mm = 3;  // rounding, and the steps of a slanted surface between instants

std::vector<fs::path> depth_files(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".png") files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

/// The median where most pictures agree with it.
DepthImage still_depth(const std::vector<DepthImage>& pictures) {
  DepthImage still(pictures[0].width(), pictures[0].height());
  std::vector<std::uint16_t> values(pictures.size());
  for (int y = 0; y < still.height(); ++y) {
    for (int x = 0; x < still.width(); ++x) {
      std::ranges::transform(pictures, values.begin(),
                             [&](const DepthImage& picture) { return picture.at(x, y); });
      const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
      std::ranges::nth_element(values, middle);
      const int median = *middle;
      const auto same = std::ranges::count_if(
          values, [&](int value) { return std::abs(value - median) <= kSameTruth_mm; });
      if (2 * static_cast<std::size_t>(same) > values.size())
        still.at(x, y) = static_cast<std::uint16_t>(median);
    }
  }
  return still;
}

/// Readings of this point by a sensor.
std::uint8_t readings_of(const StillTruth& sensor, const Eigen::Vector3d& world_m) {
  const Eigen::Vector3d at = sensor.world_from_camera.inverse() * world_m;
  const auto pixel = project(sensor.camera, at);
  if (!pixel) return 0;
  const Eigen::Vector2i place = pixel->array().round().cast<int>();
  const bool inside =
      place.minCoeff() >= 0 && place.x() < sensor.camera.width && place.y() < sensor.camera.height;
  if (!inside) return 0;
  const double true_m = 0.001 * sensor.depth_mm.at(place.x(), place.y());
  const bool same = std::abs(true_m - at.z()) <= std::max(0.02, 0.01 * at.z());
  return same ? sensor.readings.at(place.x(), place.y()) : 0;
}

void add_readings_of(std::span<const StillTruth> sensors, StillTruth& view) {
  for (int y = 0; y < view.camera.height; ++y) {
    for (int x = 0; x < view.camera.width; ++x) {
      const double z_m = 0.001 * view.depth_mm.at(x, y);
      const auto point = z_m > 0 ? unproject(view.camera, {x, y}, z_m) : std::nullopt;
      if (!point) continue;
      const Eigen::Vector3d world_m = view.world_from_camera * *point;
      for (const StillTruth& sensor : sensors)
        view.readings.at(x, y) = std::max(view.readings.at(x, y), readings_of(sensor, world_m));
    }
  }
}

void count_up(std::uint8_t& count) {
  if (count < 255) ++count;
}

CameraIntrinsics lens_of(const TruthViewEntry& entry) {
  const double f = render::focal_length_px(entry.camera);
  return {.width = entry.camera.width,
          .height = entry.camera.height,
          .fx = f,
          .fy = f,
          .cx = 0.5 * (entry.camera.width - 1),
          .cy = 0.5 * (entry.camera.height - 1)};
}

}  // namespace

Result<StillTruth> read_sensor_truth(const fs::path& rig, const recording::RigSensorEntry& sensor,
                                     const CameraIntrinsics& camera) {
  const fs::path folder = rig / "truth" / sensor.id;
  const auto files = depth_files(folder);
  if (files.empty() || !sensor.world_from_depth)
    return Error{ErrorCode::kNotFound, "the truth of sensor " + sensor.id + " is not known; " +
                                           "simulate a rig with roomcast simulate"};
  StillTruth truth{camera, *sensor.world_from_depth, {}, MaskImage(camera.width, camera.height)};
  const auto exact = io::read_camera_json(folder / "camera.json");
  if (exact) truth.camera = exact->calibration.depth;
  if (!exact && exact.error().code != ErrorCode::kNotFound) return exact.error();
  io::ImageFileReader reader;
  std::vector<DepthImage> pictures;
  const std::size_t step = (files.size() + kMaxTruthFrames - 1) / kMaxTruthFrames;
  for (std::size_t i = 0; i < files.size(); i += step) {
    const io::ImageSize size{truth.camera.width, truth.camera.height};
    pictures.emplace_back();
    if (auto status = reader.read_depth(files[i], size, pictures.back()); !status)
      return status.error();
  }
  truth.depth_mm = still_depth(pictures);
  return truth;
}

void add_readings(DepthView depth_mm, StillTruth& truth) {
  if (!same_size(depth_mm, truth.depth_mm.view())) return;
  for (int y = 0; y < depth_mm.height; ++y) {
    for (int x = 0; x < depth_mm.width; ++x) {
      const int z_mm = depth_mm.at(x, y), true_mm = truth.depth_mm.at(x, y);
      const int limit_mm = std::max(50, 3 * true_mm / 100);
      if (z_mm > 0 && true_mm > 0 && std::abs(z_mm - true_mm) <= limit_mm)
        count_up(truth.readings.at(x, y));
    }
  }
}

Result<std::vector<StillTruth>> read_view_truths(const fs::path& rig,
                                                 std::span<const StillTruth> sensors) {
  const auto views = read_truth_views(rig);
  if (!views && views.error().code == ErrorCode::kNotFound) return std::vector<StillTruth>();
  if (!views) return views.error();
  std::map<int, StillTruth> truths;
  for (const TruthViewEntry& entry : views->entries) {
    const auto view = load(entry);
    if (!view) return view.error();
    const auto [place, is_new] = truths.try_emplace(entry.view);
    StillTruth& truth = place->second;
    if (is_new)
      truth = {lens_of(entry), entry.camera.world_from_view * render::optical_from_view().inverse(),
               view->depth_mm, MaskImage(entry.camera.width, entry.camera.height)};
    for (int y = 0; y < truth.camera.height; ++y) {
      for (int x = 0; x < truth.camera.width; ++x) {
        const int change_mm = view->depth_mm.at(x, y) - truth.depth_mm.at(x, y);
        if (std::abs(change_mm) > kSameTruth_mm) truth.depth_mm.at(x, y) = 0;
      }
    }
  }
  std::vector<StillTruth> list;
  for (auto& [view, truth] : truths) {
    add_readings_of(sensors, truth);
    list.push_back(std::move(truth));
  }
  return list;
}

}  // namespace roomcast::bench
