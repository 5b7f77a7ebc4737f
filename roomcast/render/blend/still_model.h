// SPDX-License-Identifier: Apache-2.0
// StillModel: the model of what stands still in a room, in pieces, and the program that draws it
// where no sensor shows anything. Sides that face away are not drawn. Needs the GL context it was
// made with. Metres, world frame.
#pragma once

#include <array>
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

  /// Draws into the bound framebuffer, against its depth, where `shown_depth`, a picture of the
  /// same size, is infinite. Leaves out pieces that no eye sees. With `holes`, those of
  /// `shown_depth`, it also leaves out triangles without a hole nearby.
  void draw(const Eyes& eyes, const GlTexture& shown_depth, const HoleMap* holes);

 private:
  using Program = DrawProgram<Vertex<shaders::eyes_glsl, shaders::still_model_vert>,
                              Fragment<shaders::still_model_frag>>;
  struct Piece {
    GlBuffer points, indices;
    GLsizei index_count = 0;
    Eigen::AlignedBox3f box_m;
    ModelCells cells;
  };
  explicit StillModel(Program program);
  [[nodiscard]] std::vector<const Piece*> seen_pieces(const Eyes& eyes) const;
  void draw_all(std::span<const Piece* const> pieces, const Eyes& eyes) const;
  void draw_near(const HoleMap& holes, std::span<const Piece* const> pieces, const Eyes& eyes);

  Program program_;
  GlVertexArray vertices_;
  std::map<ModelPlace, Piece> pieces_;
  GlBuffer near_holes_;  // triangles of one picture
  std::vector<ModelTriangle> triangles_;
};

}  // namespace roomcast::render
