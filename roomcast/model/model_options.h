// SPDX-License-Identifier: Apache-2.0
// The numbers by which a fused model decides. Metres. Chosen on rooms of the simulator; see
// docs/benchmarks/model.md.
#pragma once

#include <cstddef>

#include "roomcast/core/option_fields.h"

namespace roomcast::model {

inline constexpr float kMaxVoxel_m = 0.2F, kMinVoxel_m = 0.002F;
/// Sensors farther from the origin than this are not of one room.
inline constexpr double kMaxRoom_m = 500;

struct ModelOptions {
  float voxel_m = 0.01F;
  float max_range_m = 10;  // readings beyond are left out
  /// Distances to a surface are known this far in front of it and behind it, in voxels, and wider
  /// where a sensor's readings are less exact.
  float truncation_voxels = 3, truncation_sigmas = 3;
  /// What averaging does not remove from a reading: a constant, and a share of the distance.
  float bias_m = 0.001F, bias_per_depth = 0.0015F;
  /// A reading belongs to the surface at a pixel when it is this close: sigmas of the noise law,
  /// and a constant.
  float same_surface_sigmas = 4, same_surface_m = 0.004F;
  /// Readings in the mean of a pixel; later ones replace the oldest. With fewer, furniture that was
  /// moved is forgotten sooner.
  int memory_frames = 120;
  /// Surfaces of fewer triangles, connected with nothing else, are stray readings.
  int min_triangles = 100;
  std::size_t max_bytes = 200'000'000;  // of the volume

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("voxel_m", voxel_m, Range{kMinVoxel_m, kMaxVoxel_m});
    visit("max_range_m", max_range_m, Range{0.1, 65});
    visit("truncation_voxels", truncation_voxels, Range{1, 8});
    visit("truncation_sigmas", truncation_sigmas, Range{0, 10});
    visit("bias_m", bias_m, Range{0.0001, 0.1});
    visit("bias_per_depth", bias_per_depth, Range{0, 0.1});
    visit("same_surface_sigmas", same_surface_sigmas, Range{1, 20});
    visit("same_surface_m", same_surface_m, Range{0, 0.1});
    visit("memory_frames", memory_frames, Range{3, 120});
  }
  [[nodiscard]] Status check() const { return check_fields("ModelOptions", *this); }
};

}  // namespace roomcast::model
