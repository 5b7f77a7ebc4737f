// SPDX-License-Identifier: Apache-2.0
// HoleRegistration: registered colour also where depth is lost: what the colour camera sees at the
// surface that was read there before, so that who receives it can tell a wall whose reading is
// missing from a dark thing before the wall. Colour of small or slight changes stays as it was:
// readings come and go at every edge. Depth in millimetres. Single-threaded; one for each sensor.
#pragma once

#include <cstdint>

#include "roomcast/core/image.h"
#include "roomcast/geometry/registration.h"

namespace roomcast {

/// The farthest surface that each pixel has read several times in a row.
class FarthestDepth {
 public:
  FarthestDepth(int width, int height);
  /// Learns from `depth_mm`, whose size is that of the constructor.
  void learn(DepthView depth_mm);
  /// 0: none yet.
  [[nodiscard]] DepthView depth_mm() const { return known_mm_; }

 private:
  DepthImage known_mm_, candidate_mm_;
  Image<std::uint8_t> candidate_readings_;
};

/// Things that give a reading here and there only (a dark screen): how far they are between these.
class SparseCover {
 public:
  SparseCover(int width, int height);
  /// The readings of a frame that lie clearly before `behind_mm`.
  void find(DepthView depth_mm, DepthView behind_mm);
  /// Between readings at three corners of a pixel that agree; 0: there are none, or it lies beside
  /// them.
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

  /// As Registration::run, but `out.color` is not black without a reading: it is what was seen
  /// there last. Allocates nothing after its first call.
  [[nodiscard]] Status run(DepthView depth_mm, ColorView color, RegisteredColor& out);

  /// Of the newest frame: 255 where its colour was taken from it: `seen`, and in holes where
  /// something else came before the surface, or went.
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
  ColorImage last_;  // the colour as it was given out last
};

}  // namespace roomcast
