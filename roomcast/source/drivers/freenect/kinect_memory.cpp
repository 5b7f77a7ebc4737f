// SPDX-License-Identifier: Apache-2.0
#include "roomcast/source/drivers/freenect/kinect_memory.h"

#include <array>
#include <cstdint>

#include <libfreenect_registration.h>

// The library that replays recordings in place of libfreenect lacks this function.
#pragma weak freenect_copy_registration
#pragma weak freenect_destroy_registration

namespace roomcast::source {
namespace {

/// libfreenect gives distances in a mixture of units, all ten times too small.
constexpr double kMillimetresPerUnit = 10;

KinectZeroPlane plane_of(const freenect_registration& memory) {
  const freenect_zero_plane_info& plane = memory.zero_plane_info;
  return {kMillimetresPerUnit * plane.dcmos_emitter_dist,
          kMillimetresPerUnit * plane.dcmos_rcmos_dist,
          kMillimetresPerUnit * plane.reference_distance,
          kMillimetresPerUnit * plane.reference_pixel_size, memory.const_shift};
}

KinectColorMap color_map_of(const freenect_registration& memory) {
  using Pixel = std::array<std::int32_t, 2>;
  static_assert(sizeof(Pixel) == sizeof(*memory.registration_table));
  return {{reinterpret_cast<const Pixel*>(memory.registration_table), kKinectWidth * kKinectHeight},
          {memory.depth_to_rgb_shift, FREENECT_DEPTH_MM_MAX_VALUE}};
}

}  // namespace

std::optional<KinectMemory> read_kinect_memory(freenect_device* device) {
  if (freenect_copy_registration == nullptr) return std::nullopt;
  freenect_registration copy = freenect_copy_registration(device);
  const bool is_connected =
      copy.registration_table != nullptr && copy.depth_to_rgb_shift != nullptr;
  std::optional<KinectMemory> memory;
  if (is_connected) {
    const KinectZeroPlane plane = plane_of(copy);
    if (auto cameras = kinect_calibration(plane, color_map_of(copy)))
      memory = KinectMemory{plane, *cameras};
  }
  freenect_destroy_registration(&copy);
  return memory;
}

}  // namespace roomcast::source
