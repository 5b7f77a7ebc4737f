// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/freenect/kinect_depth.h"

#include <cmath>
#include <cstring>

#include "roomcast/core/assert.h"

namespace roomcast::source {
namespace {

constexpr double kRawStepsPerPixel = 4;
constexpr double kSubpixelOffset = 0.375;  // between the recorded and the observed pattern
constexpr double kSensorPixelsPerDepthPixel = 2;

}  // namespace

double depth_focal_length_px(const KinectZeroPlane& plane) {
  return plane.distance_mm / (kSensorPixelsPerDepthPixel * plane.pixel_on_plane_mm);
}

std::vector<std::uint16_t> kinect_mm_from_raw(const KinectZeroPlane& plane) {
  std::vector<std::uint16_t> mm_from_raw(kKinectRawValues, 0);
  for (std::size_t raw = 0; raw < kKinectNoReading; ++raw) {
    const double shift_px =
        static_cast<double>(raw) / kRawStepsPerPixel - plane.shift_px - kSubpixelOffset;
    // Similar triangles over the base from camera to emitter, with the spot's shift on the plane.
    const double moved_mm = shift_px * plane.pixel_on_plane_mm;
    const double base_mm = plane.emitter_from_ir_camera_mm;
    const double depth_mm = plane.distance_mm * base_mm / (base_mm - moved_mm);
    if (depth_mm > 0 && depth_mm <= kFarthestKinect_mm)
      mm_from_raw[raw] = static_cast<std::uint16_t>(std::lround(depth_mm));
  }
  return mm_from_raw;
}

void kinect_depth_from_raw(const std::uint16_t* raw, const std::vector<std::uint16_t>& mm_from_raw,
                           DepthImage& depth_mm) {
  ROOMCAST_ASSERT(mm_from_raw.size() == kKinectRawValues);
  if (depth_mm.width() != kKinectWidth || depth_mm.height() != kKinectHeight)
    depth_mm.resize(kKinectWidth, kKinectHeight);
  std::uint16_t* const out = depth_mm.data();
  const auto* const bytes = reinterpret_cast<const char*>(raw);
  for (std::size_t i = 0; i < depth_mm.view().pixel_count(); ++i) {
    std::uint16_t value = 0;  // copied: a library's buffer may begin at an odd address
    std::memcpy(&value, bytes + sizeof(value) * i, sizeof(value));
    out[i] = value < kKinectRawValues ? mm_from_raw[value] : std::uint16_t{0};
  }
}

}  // namespace roomcast::source
