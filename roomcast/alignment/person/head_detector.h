// SPDX-License-Identifier: Apache-2.0
// HeadDetector: finds the heads of moving people in the view of one sensor. Readings nearer than
// the depth of the calibration bundle are foreground. In a plan view of the foreground on the floor
// (Darrell et al. 1998; Harville 2004), a blob of the size and height of a person is a person, and
// its topmost part is the head. A few milliseconds per picture. Metres, in the depth camera's
// frame. Single-threaded.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "roomcast/alignment/bundle/calibration_bundle.h"
#include "roomcast/alignment/view/floor.h"
#include "roomcast/alignment/view/planes.h"

namespace roomcast::alignment {

/// Above the floor.
inline constexpr float kMinHead_m = 1.0F, kMaxHead_m = 2.2F;
inline constexpr std::size_t kMaxHeads = 4;

/// Chosen on simulated walks (docs/benchmarks/live-alignment.md), unless noted.
struct HeadDetectorOptions {
  DepthNoiseOptions noise;
  int pixel_step = 2;  // rows and columns of the depth picture; for time
  int border_px = 8;   // depth cameras have few readings there; by hand
  float nearest_m = kNearestSurface_m;
  float before_m = 0.08F, before_sigmas = 4;  // nearer than the background by more: foreground
  float min_height_m = 0.4F;                  // lower blobs are furniture that was moved; by hand
  float cell_m = 0.08F, reach_m = 8;          // of the plan, to each side of the sensor
  float cell_area_m2 = 0.002F;                // visible surface in a cell that counts
  float person_area_m2 = 0.12F;               // visible surface of a person, at least
  float min_head_m = kMinHead_m, max_head_m = kMaxHead_m;  // top, above the floor: child, tall man
  float head_length_m = 0.20F;                             // below the top
  float crown_m = 0.05F;        // below the top: where heads differ least (ADR 14)
  float above_top_m = 0.03F;    // points so far above the top still belong to the head
  float head_radius_m = 0.16F;  // about its middle
  float above_share = 0.01F;    // of the points, above the top: flying pixels
  std::size_t max_heads = kMaxHeads;

  /// Cells of the plan along each side.
  [[nodiscard]] int cells() const { return static_cast<int>(2 * reach_m / cell_m); }

  template <class Visit>
  void for_each_field(Visit visit) const {
    visit("noise", noise);
    visit("pixel_step", pixel_step, Range{1, 100});
    visit("border_px", border_px, Range{0, 1000});
    visit("nearest_m", nearest_m, Range{0.05, 10});
    visit("before_m", before_m, Range{0, 10});
    visit("before_sigmas", before_sigmas, Range{0, 1000});
    visit("min_height_m", min_height_m, Range{0, 10});
    visit("cell_m", cell_m, Range{0.01, 1});
    visit("reach_m", reach_m, Range{1, 100});
    visit("cell_area_m2", cell_area_m2, Range{0, 10});
    visit("person_area_m2", person_area_m2, Range{0, 10});
    visit("min_head_m", min_head_m, Range{0, 10});
    visit("max_head_m", max_head_m, Range{0, 10});
    visit("head_length_m", head_length_m, Range{0.01, 1});
    visit("crown_m", crown_m, Range{0.001, 1});
    visit("above_top_m", above_top_m, Range{0, 1});
    visit("head_radius_m", head_radius_m, Range{0.01, 1});
    visit("above_share", above_share, Range{0, 0.5});
    visit("max_heads", max_heads, Range{1, 1000});
  }
  [[nodiscard]] Status check() const { return check_fields("HeadDetectorOptions", *this); }
};

/// The floor plane in the sensor's view; nothing if it sees no floor.
[[nodiscard]] std::optional<Plane> floor_of(const CalibrationBundle& bundle,
                                            const DepthSurfaceOptions& surface = {},
                                            const PlaneOptions& planes = {},
                                            const FloorOptions& floor = {});

/// Transform to the level frame: y up, the floor at y = 0, the sensor above its origin, looking
/// along -z.
[[nodiscard]] RigidTransform level_from_depth(const Plane& floor);

class HeadDetector {
 public:
  /// `bundle` has passed check(), `floor` is its floor.
  HeadDetector(const CalibrationBundle& bundle, const Plane& floor,
               const HeadDetectorOptions& options = {});
  ~HeadDetector();
  HeadDetector(HeadDetector&&) noexcept;
  HeadDetector& operator=(HeadDetector&&) noexcept;

  /// `depth_mm` has the bundle's size. Returns the centre of the visible surface of each head's
  /// crown, which is on the sensor's side of the head. Largest person first.
  [[nodiscard]] std::vector<Eigen::Vector3f> find(DepthView depth_mm);

 private:
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace roomcast::alignment
