// SPDX-License-Identifier: Apache-2.0
// ViewSurface: a StillView prepared for questions about points of space: how far in front of or
// behind its surface they are, and how surely that is known. Depth is interpolated between pixels
// of one surface, so that planes stay planes; its weight comes from the sensor's noise law, the
// number of readings, the angle of view and the distance from the rim of the surface. Metres, world
// frame. Immutable; thread-safe.
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/model/model_options.h"
#include "roomcast/model/still_view.h"

namespace roomcast::model {

/// What a view knows about a point.
struct ViewSample {
  float distance_m = 0;    // from the surface, positive in front of it
  float truncation_m = 0;  // behind the surface nothing is known beyond this
  float weight = 0;
  float free_weight = 0;   // that nothing is there, where the point is far in front of the surface
  Eigen::Vector3f normal;  // of the surface; world frame, towards the sensor
};

class ViewSurface {
 public:
  ViewSurface(const StillView& view, const ModelOptions& options);

  /// Nothing where no reading is, or the point is not in the picture.
  [[nodiscard]] std::optional<ViewSample> sample(const Eigen::Vector3f& world_m) const;

  /// False if no point of this ball can be in the picture.
  [[nodiscard]] bool may_see(const Eigen::Vector3f& center_m, float radius_m) const;

  /// The mean colour of the surface where it is at most `tolerance_m` from this point, and how good
  /// the view of it is.
  struct Colored {
    Eigen::Vector3f color;  // levels, 0 to 255
    float quality = 0;
  };
  [[nodiscard]] std::optional<Colored> color(const Eigen::Vector3f& world_m,
                                             float tolerance_m) const;

  struct Texel {
    float inverse_m = 0;  // 1 / depth; 0 for none
    float truncation_m = 0, weight = 0;
    float rim = 0;                                     // 1 within a surface, less near its rim
    float plane_m = 0;                                 // normal * point of the surface
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();  // sensor frame, towards the sensor
    bool joins_right = false, joins_down = false;      // one surface with that neighbour
    bool has_color = false;
    Rgb8 color;
  };
  [[nodiscard]] const Image<Texel>& texels() const { return texels_; }
  [[nodiscard]] Eigen::Vector3f world_point(int x, int y) const;
  /// The four pixels from (x, y) on to the right and down are of one surface.
  [[nodiscard]] bool is_quad(int x, int y) const;

 private:
  void read(const StillView& view);
  void join();
  void drop_stray(const StillView& view);
  void fill_holes();
  void fill_hole(int x, int y, const Image<Texel>& before);
  void add_normals();
  void weigh(const StillView& view);
  [[nodiscard]] bool is_joined(int x, int y, int dx, int dy) const;
  /// How many of the eight neighbours, of those that `counts` takes.
  template <class Counts>
  [[nodiscard]] int joined_neighbours(int x, int y, const Counts& counts) const;
  [[nodiscard]] std::optional<Eigen::Vector3f> surface_step(int x, int y, int dx, int dy) const;
  [[nodiscard]] bool project(const Eigen::Vector3f& point_m, float& u, float& v) const;
  [[nodiscard]] Eigen::Vector3f point(int x, int y) const;

  CameraIntrinsics camera_;
  ModelOptions options_;
  Eigen::Matrix3f depth_from_world_, world_from_depth_;
  Eigen::Vector3f depth_origin_m_, world_origin_m_;
  float largest_radius2_ = 0;
  Image<Eigen::Vector2f> rays_;
  Image<Texel> texels_;
};

}  // namespace roomcast::model
