// SPDX-License-Identifier: Apache-2.0
// StillModel: the model of what stands still in a room, in pieces, and the program that draws it
// where no sensor shows anything. Sides that face away are not drawn. Needs the GL context it was
// made with. Metres, world frame.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/render/blend/hole_map.h"
#include "roomcast/render/blend/model_cells.h"
#include "roomcast/render/gl/shaders.h"
#include "roomcast/render/view/eyes.h"

namespace roomcast::render {

/// Names a piece: the place of its cube in a grid.
using ModelPlace = std::array<std::int32_t, 3>;

/// The mesh of a piece: one colour for each point; triangles counter-clockwise as seen from the
/// room.
struct ModelSurface {
  std::span<const Eigen::Vector3f> points_m = {};
  std::span<const Rgb8> colors = {};
  std::span<const ModelTriangle> triangles = {};
};

class StillModel {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<StillModel> create();

  /// Replaces the piece there; without triangles it is removed. kInvalidArgument, without changes,
  /// if colours are missing or a triangle has a point that does not exist.
  Status set_piece(const ModelPlace& place, const ModelSurface& surface);
  void clear() { pieces_.clear(); }
  [[nodiscard]] bool is_empty() const { return pieces_.empty(); }

  /// Whether draw() is faster with holes, because a software driver draws. A graphics card would
  /// wait for the picture in which they are found.
  [[nodiscard]] bool wants_holes() const { return in_software_; }

  /// Draws into the bound framebuffer, against its depth, where `shown_depth`, a picture of the
  /// same size, is infinite. Leaves out pieces that no eye sees. With `holes`, those of
  /// `shown_depth`, it also leaves out triangles without a hole nearby; only where it wants them.
  void draw(const Eyes& eyes, const GlTexture& shown_depth, const HoleMap* holes);

 private:
  using Program = DrawProgram<Vertex<shaders::eyes_glsl, shaders::still_model_vert>,
                              Fragment<shaders::still_model_frag>>;
  struct Piece {
    GlBuffer points, indices;
    GLsizei index_count = 0;
    Eigen::AlignedBox3f box_m;
    ModelCells cells;  // empty unless holes are wanted
  };
  explicit StillModel(Program program);
  void find_seen_pieces(const Eyes& eyes);
  void draw_all(const Eyes& eyes) const;
  void draw_near(const HoleMap& holes, const Eyes& eyes);

  Program program_;
  GlVertexArray vertices_;
  bool in_software_;
  std::map<ModelPlace, Piece> pieces_;
  // Of one picture; the vectors are kept so that the next picture needs no memory for them.
  std::vector<const Piece*> seen_;
  std::vector<ModelTriangle> triangles_;  // near holes
  std::vector<std::size_t> ends_;         // of each seen piece's triangles
  GlBuffer near_holes_;                   // these triangles; made anew for each picture
};

}  // namespace roomcast::render
