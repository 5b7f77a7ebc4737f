// SPDX-License-Identifier: Apache-2.0
// CleanSurface: a surface of one sensor made ready to be mixed with others: depth without small
// holes and most of its noise, how much each pixel counts, and its triangles. SurfaceCleaner makes
// it on the GPU, once per frame. Steps and constants as measured in a prototype; the shaders say
// what each does. Needs the GL context it was made with.
#pragma once

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/render/blend/adaptive_mesh.h"
#include "roomcast/render/blend/compute_pass.h"
#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {

struct CleanSurface {
  explicit CleanSurface(const CameraIntrinsics& lens);
  /// Colour pixels for each pixel of depth and direction: 1, 2, 4, ...
  void set_color_scale(int scale);

  int width, height;
  int color_scale = 1;
  GlTexture depth_m;         // R32F, 0: nothing
  GlTexture quality;         // R16F: how much it counts beside others
  GlTexture weighted_color;  // RGBA16F, scaled: rgb times quality, quality; 0 without a colour
  AdaptiveMesh mesh;
  GlTexture between, edge_in_row, still_color;  // of the steps on the way
};

class SurfaceCleaner {
 public:
  /// kUnsupported with the driver's log when it does not take the shaders.
  static Result<SurfaceCleaner> create();

  /// What is remembered: metres and readings; mean colour and of how many. And where the newest
  /// colour is to be believed.
  struct Known {
    const GlTexture& readings;
    const GlTexture& color;
    const GlTexture& seen;
  };
  enum class Shows { kNewest, kBackground };
  struct Options {
    SurfaceMeshOptions mesh;
    Eigen::Vector3f gain = Eigen::Vector3f::Ones();  // of its colours, red first
    const CleanSurface* covering = nullptr;          // what lies on it is not drawn
  };

  /// Fills small holes of `surface.depth_m`, which is that of what it shows, in place; the rims of
  /// things that are live, too.
  void repair(Shows shows, CleanSurface& surface);

  /// Smooths it and derives the rest.
  void finish(const SensorSurface& sensor, const Known& known, Shows shows, const Options& options,
              CleanSurface& surface);

 private:
  struct Passes {
    ComputePass fill, extend, smooth, edges, quality, still, color;
  };
  SurfaceCleaner(Passes passes, AdaptiveMesher mesher);
  static void filter(const ComputePass& pass, CleanSurface& surface);
  void still_colors(const SensorSurface& sensor, const Known& known, CleanSurface& surface);
  void weigh_colors(const GlTexture& color, const Eigen::Vector3f& gain, CleanSurface& surface);
  static void run_on_colors(const ComputePass& pass, const CleanSurface& surface);

  Passes passes_;
  AdaptiveMesher mesher_;
};

}  // namespace roomcast::render
