// SPDX-License-Identifier: Apache-2.0
// Leave one sensor out: draws what it sees from the frames of the others, and compares that with
// its own picture. The judge needs no truth, so it works on recordings of real rooms. Frames are
// registered but not encoded, and come in the order of their times, as in a live room.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "bench/render/rig_frames.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/render/view/view_camera.h"

namespace roomcast::bench {

struct LeftOutPicture {
  std::string sensor;
  std::uint64_t frame = 0;
  ColorImage own, drawn;  // in the depth grid of the sensor; black where nothing is known
  /// Over the pixels that have a colour of the sensor's own and that the others show: PSNR of the
  /// three channels in dB, SSIM of the grey picture (view_score.h). NaN where there are none.
  double psnr_db = 0, ssim = 0;
  double covered = 0;      // share of the sensor's coloured pixels that the others show
  double wrong_depth = 0;  // share of the covered pixels off by more than 6 cm and 3 %
};

/// The pinhole view that contains everything a sensor with this lens and pose sees, at the lens's
/// resolution.
[[nodiscard]] render::ViewCamera view_around(const CameraIntrinsics& lens,
                                             const RigidTransform& world_from_depth);

/// A picture drawn by `view_around`, in the grid of the lens (nearest pixel). Pixels without a ray
/// are empty.
template <class T>
[[nodiscard]] Image<T> in_grid_of(const CameraIntrinsics& lens, const render::ViewCamera& view,
                                  const Image<T>& drawn);

/// `count` frames of sensor number `left_out`, evenly spread. Needs a current GL context and at
/// least one other sensor. Restarts `frames`. Errors of the files and of the renderer.
[[nodiscard]] Result<std::vector<LeftOutPicture>> draw_without(
    RigFrames& frames, std::size_t left_out, int count,
    const std::function<void(const std::string&)>& progress);

}  // namespace roomcast::bench
