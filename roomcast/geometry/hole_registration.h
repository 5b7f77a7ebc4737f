// SPDX-License-Identifier: Apache-2.0
// HoleRegistration: registered colour also for pixels without depth. A pixel without a reading gets
// the colour that the colour camera sees at the surface read there before, so that a receiver can
// distinguish a wall with missing depth from a dark object in front of it. Small or slight colour
// changes are ignored, because readings come and go at every edge. Depth in millimetres.
// Single-threaded; one instance per sensor.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/geometry/registration.h"

namespace roomcast {

/// The farthest surface that each pixel has read several times in a row.
class FarthestDepth {
 public:
  FarthestDepth(int width, int height);
  /// Updates the estimate from `depth_mm`, whose size is that of the constructor.
  void learn(DepthView depth_mm);
  /// 0: none yet.
  [[nodiscard]] DepthView depth_mm() const { return known_mm_; }

 private:
  DepthImage known_mm_, candidate_mm_;
  Image<std::uint8_t> candidate_readings_;
};

/// Depth of objects that return only sparse readings (a dark screen), interpolated between these.
class SparseCover {
 public:
  SparseCover(int width, int height);
  /// Collects the readings of a frame that are clearly in front of `behind_mm`.
  void find(DepthView depth_mm, DepthView behind_mm);
  /// Mean of the readings in the diagonally neighbouring cells, if at least three of them have
  /// readings and these agree; else 0.
  [[nodiscard]] int between_mm(int x, int y) const;

 private:
  struct Cell {
    int sum_mm = 0, readings = 0;
  };
  Image<Cell> cells_;
};

class HoleRegistration {
 public:
  /// Errors as Registration::create.
  static Result<HoleRegistration> create(const SensorCalibration& calibration,
                                         const RegistrationOptions& options = {});

  /// As Registration::run, but `out.color` is not black without a reading: it is the last colour
  /// stored there. Allocates nothing after its first call.
  [[nodiscard]] Status run(DepthView depth_mm, ColorView color, RegisteredColor& out);

  /// For the newest frame: 255 where the colour was taken from it, which is where `seen` is set,
  /// and in holes whose colour clearly changed; 0 elsewhere.
  [[nodiscard]] MaskView fresh() const { return fresh_; }

 private:
  HoleRegistration(Registration registration, const SensorCalibration& calibration,
                   int color_scale);
  void fill(DepthView depth_mm);
  void find_changes();
  [[nodiscard]] bool is_changed(int x, int y) const;
  [[nodiscard]] bool is_in_patch(int x, int y) const;
  void keep_colors(DepthView depth_mm, RegisteredColor& out);
  void keep_color(int x, int y, const ColorImage& now, bool is_new, ColorImage& out);

  Registration registration_;
  int color_scale_;
  FarthestDepth farthest_;
  SparseCover cover_;
  DepthImage filled_mm_;
  RegisteredColor in_holes_;
  MaskImage changed_, fresh_;
  ColorImage last_;  // the colour as last output
};

}  // namespace roomcast
