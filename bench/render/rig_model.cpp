// SPDX-License-Identifier: Apache-2.0
#include "bench/render/rig_model.h"

#include <utility>
#include <vector>

#include "roomcast/model/still_view.h"
#include "roomcast/model/view_surface.h"
#include "roomcast/recording/mesh/mesh_writer.h"
#include "roomcast/recording/modeler/room_modeler.h"

namespace roomcast::bench {
namespace {

/// Every second pixel of colour that is twice as fine as depth.
template <class T>
Image<T> in_depth_grid(const Image<T>& fine, const DepthImage& depth_mm) {
  if (fine.width() == depth_mm.width()) return fine;
  Image<T> picked(depth_mm.width(), depth_mm.height());
  for (int y = 0; y < picked.height(); ++y) {
    for (int x = 0; x < picked.width(); ++x) picked.at(x, y) = fine.at(2 * x, 2 * y);
  }
  return picked;
}

}  // namespace

Result<model::RoomMesh> fuse_rig(
    RigFrames& frames, std::span<const RigidTransform> poses,
    const std::function<bool(std::size_t sensor, std::uint64_t number)>& is_left_out) {
  recording::MeshWriterOptions meshing;
  meshing.model.voxel_m = recording::running_room_options().voxel_m;
  meshing.colored_only = true;
  std::vector<model::ViewSurface> surfaces;
  RegisteredFrame frame;
  for (std::size_t s = 0; s < frames.sensors().size(); ++s) {
    RigFrames::Sensor& sensor = frames.sensors()[s];
    auto view = model::StillView::create(sensor.recording.camera.calibration.depth, poses[s],
                                         meshing.model);
    if (!view) return view.error();
    for (const recording::RecordedFrame& file : sensor.recording.frames) {
      if (is_left_out(s, file.index)) continue;
      if (auto status = frames.read(sensor, file.index, frame); !status) return status.error();
      view->add(frame.depth_mm, in_depth_grid(frame.color.color, frame.depth_mm),
                in_depth_grid(frame.color.seen, frame.depth_mm));
    }
    surfaces.emplace_back(*view, meshing.model);
  }
  return recording::mesh_surfaces(surfaces, meshing, {}, Workers());
}

}  // namespace roomcast::bench
