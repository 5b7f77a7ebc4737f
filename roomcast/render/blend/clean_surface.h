// SPDX-License-Identifier: Apache-2.0
// CleanSurface: one sensor's surface, prepared for mixing with others: depth without small holes
// and with less noise, a weight per pixel, colour, and triangles. SurfaceCleaner computes it on the
// GPU once per frame. The steps and constants were measured in a prototype; the shaders describe
// each step. Needs the GL context it was made with.
#pragma once

#include <utility>

#include <Eigen/Core>

#include "roomcast/core/result.h"
#include "roomcast/render/blend/adaptive_mesh.h"
#include "roomcast/render/surface/sensor_surface.h"

namespace roomcast::render {

struct CleanSurface {
  explicit CleanSurface(const CameraIntrinsics& lens);
  /// Colour pixels per depth pixel along each axis: 1, 2, 4, ...
  void set_color_scale(int scale);

  int width, height;
  int color_scale = 1;
  GlTexture depth_m;         // R32F, 0: no surface
  GlTexture quality;         // R16F: weight of the pixel when surfaces are mixed
  GlTexture weighted_color;  // RGBA16F, scaled: rgb times quality, quality; 0 without a colour
  AdaptiveMesh mesh;
  AdaptiveMesh foreground;  // the triangles before a known background; live surfaces only
  GlTexture between, edge_in_row, still_color;  // intermediate results
};

class SurfaceCleaner {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<SurfaceCleaner> create();

  /// The background model: metres and number of readings; mean colour and number of samples.
  /// `seen`: where the newest colour is valid.
  struct Known {
    const GlTexture& readings;
    const GlTexture& color;
    const GlTexture& seen;
  };
  enum class Shows { kNewest, kBackground };
  struct Options {
    SurfaceMeshOptions mesh;
    Eigen::Vector3f gain = Eigen::Vector3f::Ones();  // for the sensor's colours, red first
    const CleanSurface* covering = nullptr;          // parts on this surface are not drawn
  };

  /// Fills small holes of `surface.depth_m` in place; for kNewest also extends the edges of
  /// objects.
  void repair(Shows shows, CleanSurface& surface);

  /// Smooths `surface.depth_m` and computes the other textures and the mesh.
  void finish(const SensorSurface& sensor, const Known& known, Shows shows, const Options& options,
              CleanSurface& surface);

  /// Finds the foreground of a finished surface: what is before a known background, and what moves
  /// (`velocities`: of SurfaceFlow) before an unknown one.
  void find_foreground(const CleanSurface& background, const SurfaceMeshOptions& options,
                       const GlTexture& velocities, CleanSurface& surface);

 private:
  struct Parts {
    ComputeProgram<shaders::fill_small_comp> fill;
    ComputeProgram<shaders::extend_edges_comp> extend;
    ComputeProgram<shaders::depth_noise_glsl, shaders::smooth_comp> smooth;
    ComputeProgram<shaders::edge_distance_comp> edges;
    ComputeProgram<shaders::quality_comp> quality;
    ComputeProgram<shaders::depth_noise_glsl, shaders::still_color_comp> still;
    ComputeProgram<shaders::weighted_color_comp> color;
    AdaptiveMesher mesher;
  };
  explicit SurfaceCleaner(Parts parts) : parts_(std::move(parts)) {}
  void weigh_pixels(const GlTexture& rays, CleanSurface& surface);
  void still_colors(const SensorSurface& sensor, const Known& known, CleanSurface& surface);
  void weigh_colors(const GlTexture& color, const Eigen::Vector3f& gain, CleanSurface& surface);

  Parts parts_;
};

}  // namespace roomcast::render
