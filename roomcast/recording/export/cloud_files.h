// SPDX-License-Identifier: Apache-2.0
// Encodes point clouds as PLY and PCD files, little-endian:
//   PLY  binary 1.0: x y z nx ny nz (float), red green blue (uchar)   (Turk 1994)
//   PCD  binary 0.7: x y z normal_x normal_y normal_z (float), rgb (float, 0x00RRGGBB)  (PCL)
// Metres. A comment tells when the cloud was captured, where that is known. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <vector>

#include "roomcast/core/clock.h"
#include "roomcast/recording/export/point_cloud.h"

namespace roomcast::recording {

/// `captured`: since 1970-01-01 UTC; 0: unknown.
void append_ply(const PointCloud& cloud, nanoseconds captured, std::vector<std::uint8_t>& out);
void append_pcd(const PointCloud& cloud, nanoseconds captured, std::vector<std::uint8_t>& out);

}  // namespace roomcast::recording
