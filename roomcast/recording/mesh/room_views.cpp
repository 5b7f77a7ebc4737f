// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/mesh/room_views.h"

#include <algorithm>
#include <utility>

#include "roomcast/recording/mesh/pose_change.h"

namespace roomcast::recording {
namespace {

std::size_t pixels_of(const CameraIntrinsics& camera) {
  return static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
}

Error of_sensor(const std::string& name, const Error& error) {
  return {error.code, "sensor " + name + ": " + error.message};
}

}  // namespace

RoomViews::RoomViews(const std::vector<SetSensor>& sensors, const model::ModelOptions& options)
    : sensors_(sensors), options_(options), newest_(sensors.size()) {}

Status RoomViews::add(const FrameSet& set) {
  for (const SetFrame& frame : set.frames) {
    if (auto status = add_frame(frame, sensors_.size() == 1); !status) return status;
  }
  return {};
}

Status RoomViews::add_frame(const SetFrame& frame, bool alone) {
  const bool again = frame.time == std::exchange(newest_[frame.sensor].time, frame.time);
  if (again || (!frame.world_from_depth && !alone)) return {};
  const CameraIntrinsics& camera = sensors_[frame.sensor].depth;
  const codec::DecodedFrame& pictures = *frame.pictures;
  if (pictures.depth_mm.width() != camera.width || pictures.depth_mm.height() != camera.height)
    return {};
  const auto view = view_of(frame, alone);
  if (!view) return of_sensor(sensors_[frame.sensor].name, view.error());
  if (!*view) return {};
  const bool has_color = same_size(pictures.color.view(), pictures.depth_mm.view());
  views_[**view].still.add(pictures.depth_mm, has_color ? pictures.color.view() : ColorView(),
                           pictures.color_seen);
  ++frames_;
  return {};
}

Result<std::optional<std::size_t>> RoomViews::view_of(const SetFrame& frame, bool alone) {
  const RigidTransform pose = frame.world_from_depth.value_or(RigidTransform());
  Newest& newest = newest_[frame.sensor];
  if (newest.view) {
    model::StillView& still = views_[*newest.view].still;
    const bool agrees = still.agrees(frame.pictures->depth_mm);
    if (alone && !frame.world_from_depth && !agrees)
      return Error{
          ErrorCode::kNotFound,
          "it moves, and its poses are not known; a mesh needs a sensor that stands still, "
          "or poses"};
    const PoseChange change = pose_change(still.world_from_depth(), pose);
    if (change == PoseChange::kNone) return agrees ? newest.view : std::optional<std::size_t>();
    if (agrees && change == PoseChange::kRefined) {
      if (auto status = still.set_pose(pose); !status) return status.error();
      return newest.view;
    }
  }
  const CameraIntrinsics& camera = sensors_[frame.sensor].depth;
  auto still = model::StillView::create(camera, pose, options_);
  if (!still) return still.error();
  newest.view.reset();
  make_space(pixels_of(camera));
  newest.view = views_.size();
  views_.push_back({frame.sensor, *std::move(still)});
  return newest.view;
}

void RoomViews::make_space(std::size_t pixels) {
  for (const View& view : views_) pixels += pixels_of(view.still.camera());
  while (pixels > kMaxPixelsOfViews && !views_.empty()) {
    const auto shortest =
        std::ranges::min_element(views_, {}, [](const View& view) { return view.still.frames(); });
    pixels -= pixels_of(shortest->still.camera());
    const auto number = static_cast<std::size_t>(shortest - views_.begin());
    for (Newest& newest : newest_) {
      if (!newest.view || *newest.view < number) continue;
      newest.view = *newest.view == number ? std::nullopt : std::optional(*newest.view - 1);
    }
    views_.erase(shortest);
  }
}

std::vector<model::ViewSurface> RoomViews::take_surfaces() {
  std::vector<model::ViewSurface> surfaces;
  surfaces.reserve(views_.size());
  while (!views_.empty()) {
    surfaces.emplace_back(views_.back().still, options_);
    views_.pop_back();
  }
  std::ranges::fill(newest_, Newest());
  return surfaces;
}

}  // namespace roomcast::recording
