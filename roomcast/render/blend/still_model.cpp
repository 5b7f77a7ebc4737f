// SPDX-License-Identifier: Apache-2.0
#include "roomcast/render/blend/still_model.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "roomcast/render/gl/gl_context.h"
#include "roomcast/render/gl/gl_state.h"

namespace roomcast::render {
namespace {

struct ModelPoint {
  std::array<float, 3> at_m;
  std::array<std::uint8_t, 4> level;
};

template <class T>
GlBuffer filled_buffer(std::span<const T> values) {
  GlBuffer buffer = GlBuffer::create();
  glNamedBufferStorage(buffer.name(), static_cast<GLsizeiptr>(values.size_bytes()), values.data(),
                       0);
  return buffer;
}

/// Beyond one of the planes that bound the picture.
bool is_outside(const Eigen::AlignedBox3f& box_m, const Eigen::Matrix4f& clip_from_world) {
  std::array<int, 5> beyond{};  // left, right, below, above, behind the eye: of the box's 8 corners
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3f at_m = box_m.corner(static_cast<Eigen::AlignedBox3f::CornerType>(corner));
    const Eigen::Vector4f clip = clip_from_world * at_m.homogeneous();
    const float w = clip.w();
    beyond[0] += clip.x() < -w;
    beyond[1] += clip.x() > w;
    beyond[2] += clip.y() < -w;
    beyond[3] += clip.y() > w;
    beyond[4] += clip.z() < -w;
  }
  return std::ranges::find(beyond, 8) != beyond.end();
}

}  // namespace

Result<StillModel> StillModel::create() {
  Result<Program> program = Program::create();
  if (!program) return std::move(program).error();
  return StillModel(*std::move(program));
}

StillModel::StillModel(Program program)
    : program_(std::move(program)),
      vertices_(GlVertexArray::create()),
      in_software_(is_in_software(reinterpret_cast<const char*>(glGetString(GL_RENDERER)))) {
  const auto declare = [&](GLuint input, GLint size, GLenum type, GLboolean normalized,
                           std::size_t offset) {
    glEnableVertexArrayAttrib(vertices_.name(), input);
    glVertexArrayAttribFormat(vertices_.name(), input, size, type, normalized,
                              static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(vertices_.name(), input, 0);
  };
  declare(shaders::still_model_vert::at_m.location, 3, GL_FLOAT, GL_FALSE,
          offsetof(ModelPoint, at_m));
  declare(shaders::still_model_vert::level.location, 4, GL_UNSIGNED_BYTE, GL_TRUE,
          offsetof(ModelPoint, level));
}

Status StillModel::set_piece(const ModelPlace& place, const ModelSurface& surface) {
  if (surface.triangles.empty()) {
    pieces_.erase(place);
    return {};
  }
  const std::size_t count = surface.points_m.size();
  const auto is_beyond = [&](const ModelTriangle& triangle) {
    return std::ranges::any_of(triangle, [&](std::uint32_t point) { return point >= count; });
  };
  if (surface.colors.size() != count || std::ranges::any_of(surface.triangles, is_beyond))
    return invalid_argument("a piece of the model lacks points or colours");
  Piece piece;
  std::vector<ModelPoint> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector3f& at_m = surface.points_m[i];
    const Rgb8 color = surface.colors[i];
    piece.box_m.extend(at_m);
    points.push_back({{at_m.x(), at_m.y(), at_m.z()}, {color.r, color.g, color.b, 255}});
  }
  piece.points = filled_buffer(std::span<const ModelPoint>(points));
  piece.indices = filled_buffer(surface.triangles);
  piece.index_count = static_cast<GLsizei>(3 * surface.triangles.size());
  if (in_software_) piece.cells = ModelCells(surface.points_m, surface.triangles);
  pieces_.insert_or_assign(place, std::move(piece));
  return {};
}

void StillModel::find_seen_pieces(const Eyes& eyes) {
  const EyeMatrices clip = clip_from_world(eyes);
  seen_.clear();
  for (const auto& [place, piece] : pieces_) {
    if (is_outside(piece.box_m, clip[0]) && (eyes.count() == 1 || is_outside(piece.box_m, clip[1])))
      continue;
    seen_.push_back(&piece);
  }
}

void StillModel::draw_all(const Eyes& eyes) const {
  for (const Piece* piece : seen_) {
    glVertexArrayVertexBuffer(vertices_.name(), 0, piece->points.name(), 0, sizeof(ModelPoint));
    glVertexArrayElementBuffer(vertices_.name(), piece->indices.name());
    glDrawElementsInstanced(GL_TRIANGLES, piece->index_count, GL_UNSIGNED_INT, nullptr,
                            eyes.count());
  }
}

void StillModel::draw_near(const HoleMap& holes, const Eyes& eyes) {
  triangles_.clear();
  ends_.clear();
  for (const Piece* piece : seen_) {
    piece->cells.add_near_holes(eyes, holes, triangles_);
    ends_.push_back(triangles_.size());
  }
  near_holes_ = filled_buffer(std::span<const ModelTriangle>(triangles_));
  glVertexArrayElementBuffer(vertices_.name(), near_holes_.name());
  std::size_t begin = 0;
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    if (ends_[i] == begin) continue;
    const std::size_t count = 3 * (ends_[i] - begin);
    const auto* const first = reinterpret_cast<const void*>(begin * sizeof(ModelTriangle));
    glVertexArrayVertexBuffer(vertices_.name(), 0, seen_[i]->points.name(), 0, sizeof(ModelPoint));
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT, first,
                            eyes.count());
    begin = ends_[i];
  }
}

void StillModel::draw(const Eyes& eyes, const GlTexture& shown_depth, const HoleMap* holes) {
  const EyeBorders borders(eyes);
  set_eyes(program_, eyes);
  program_.set(shaders::still_model_vert::clip_from_world, clip_from_world(eyes));
  program_.bind(shaders::still_model_frag::shown_depth, shown_depth);
  program_.use();
  glBindVertexArray(vertices_.name());
  const Enabled culling(GL_CULL_FACE);
  glCullFace(GL_BACK);
  find_seen_pieces(eyes);
  if (holes != nullptr) {
    draw_near(*holes, eyes);
  } else {
    draw_all(eyes);
  }
}

}  // namespace roomcast::render
