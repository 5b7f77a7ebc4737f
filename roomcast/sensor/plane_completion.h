// SPDX-License-Identifier: Apache-2.0
// PlaneCompletion: depth where a large plane returns none. A polished or dark floor mirrors or
// swallows a depth camera's light except close to it, so its far part is a hole, although the
// colour camera sees it. The hole gets the depth of the plane that its border lies on. It is filled
// only where
// - the sensor never saw anything else: a thing that merely lost its readings does not become
//   transparent, for the sensor has seen other readings there, or colours that the plane has not;
// - the border of the hole supports the plane, nothing at the border is seen behind it, and no
// nearer
//   plane is as good. The border refines the
// plane,
//   too: where a wall or a foot meets the floor is known far beyond the floor's own readings;
// - the colour there is one of those that the plane has where it gives readings, and stays the
// same:
//   what stands or moves in front is not painted on the plane. The exception is a hole without any
//   reading ever that a wall surrounds: a window, a picture behind glass, a screen.
// Planes are found anew after half a second, then ever less often, every five seconds in the end;
// only then memory is allocated. Single-threaded.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/geometry/camera_model.h"
#include "roomcast/sensor/plane_finder.h"

namespace roomcast::sensor {

class PlaneCompletion {
 public:
  explicit PlaneCompletion(const SensorCalibration& calibration);

  /// Takes the next frame, of the calibration's sizes, and fills its holes. Without colour nothing
  /// is filled.
  void complete(DepthImage& depth_mm, ColorView color);

  /// Pixels that were filled in the newest frame.
  [[nodiscard]] int filled() const { return filled_; }

 private:
  struct History {
    std::uint16_t last_mm = 0;       // the newest reading; 0: none so far
    std::uint16_t frames_since = 0;  // then, up to a limit
  };
  struct Fill {
    std::uint32_t pixel = 0, color_pixel = 0;
    std::uint16_t depth_mm = 0;
    std::uint8_t mean[3] = {};  // colour there
  };
  /// Open pixels that are connected, and the known pixels next to them.
  struct Hole {
    std::vector<std::uint32_t> pixels, border;
  };
  class ColorModel;

  void remember(DepthView depth_mm);
  void plan(DepthView depth_mm, ColorView color);
  void find_holes();
  void collect_hole(int x, int y);
  void refine_planes();
  [[nodiscard]] Eigen::Vector3f last_point_m(std::uint32_t pixel) const;
  [[nodiscard]] bool is_open(std::uint32_t pixel) const;
  [[nodiscard]] bool faces(const Plane& plane, std::uint32_t pixel) const;
  [[nodiscard]] double open_share() const;
  [[nodiscard]] bool is_foreign(std::uint32_t pixel, float depth_m) const;
  void plan_hole(const Hole& hole, const std::vector<ColorModel>& models, ColorView color);
  [[nodiscard]] float support_of(const Plane& plane, const Hole& hole) const;
  [[nodiscard]] std::uint32_t color_pixel_of(std::uint32_t pixel, float depth_m) const;
  [[nodiscard]] ColorModel model_of(const Plane& plane, ColorView color) const;
  void fill(DepthImage& depth_mm, ColorView color);

  SensorCalibration calibration_;
  Image<Eigen::Vector2f> rays_;
  Image<History> history_;
  int frames_ = 0, filled_ = 0;
  int next_plan_, gap_;  // frames
  float farthest_m_ = 0;
  std::vector<Plane> planes_;
  std::vector<Fill> fills_;
  MaskImage visited_;  // while holes are being found
  std::vector<Hole> holes_;
};

}  // namespace roomcast::sensor
