// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdlib>
#include <vector>

#include "roomcast/render/blend/adaptive_mesh.h"
#include "roomcast/render/gl/gl_fixture.h"

namespace roomcast::render {
namespace {

using Triangle = std::array<GLuint, 3>;
constexpr int kAdaptiveMeshWidth = 65, kAdaptiveMeshHeight = 49;

class AdaptiveMeshTest : public GlTest {
 protected:
  static GlTexture texture_of(const Image<float>& depth_m) {
    GlTexture texture = make_texture(GL_R32F, depth_m.width(), depth_m.height());
    glTextureSubImage2D(texture.name(), 0, 0, 0, depth_m.width(), depth_m.height(), GL_RED,
                        GL_FLOAT, depth_m.data());
    return texture;
  }

  std::vector<Triangle> triangles_of(const Image<float>& depth_m,
                                     const Image<float>* covering = nullptr) {
    Result<AdaptiveMesher> mesher = AdaptiveMesher::create();
    EXPECT_TRUE(mesher.ok()) << mesher.error().message;
    const GlTexture cover = covering ? texture_of(*covering) : GlTexture();
    return triangles_of(depth_m, AdaptiveMesher::Covering{covering ? &cover : nullptr}, *mesher);
  }

  static std::vector<Triangle> triangles_of(const Image<float>& depth_m,
                                            const AdaptiveMesher::Covering& covering,
                                            AdaptiveMesher& mesher) {
    const GlTexture depth = texture_of(depth_m);
    AdaptiveMesh mesh;
    mesher.build(depth, covering, depth_m.width(), depth_m.height(), {}, mesh);
    GLuint count = 0;
    glGetNamedBufferSubData(mesh.commands.name(), 0, sizeof count, &count);
    std::vector<Triangle> triangles(count / 3);
    if (!triangles.empty()) {
      glGetNamedBufferSubData(mesh.indices.name(), 0,
                              static_cast<GLsizeiptr>(count * sizeof(GLuint)), triangles.data());
    }
    return triangles;
  }
};

// An index encodes a pixel as in shaders/blend/blend_surface.glsl.
int column(GLuint index) {
  return static_cast<int>(index & 0xffffU);
}
int row(GLuint index) {
  return static_cast<int>(index >> 16U);
}
float at_index(const Image<float>& depth, GLuint index) {
  return depth.at(column(index), row(index));
}

/// Twice the area in grid cells; positive for triangles that are counter-clockwise as seen from the
/// sensor.
int twice_area(const Triangle& t) {
  return (column(t[2]) - column(t[0])) * (row(t[1]) - row(t[0])) -
         (column(t[1]) - column(t[0])) * (row(t[2]) - row(t[0]));
}

int cells_covered(const std::vector<Triangle>& triangles) {
  int twice = 0;
  for (const Triangle& t : triangles) {
    EXPECT_GT(twice_area(t), 0);
    twice += twice_area(t);
  }
  return twice / 2;
}

TEST_F(AdaptiveMeshTest, a_wall_is_a_few_large_triangles_that_cover_it_once) {
  const auto triangles = triangles_of(Image<float>(kAdaptiveMeshWidth, kAdaptiveMeshHeight, 2.0F));
  EXPECT_EQ(triangles.size(), 4U * 3U * 2U);
  EXPECT_EQ(cells_covered(triangles), (kAdaptiveMeshWidth - 1) * (kAdaptiveMeshHeight - 1));
}

TEST_F(AdaptiveMeshTest, a_slanted_wall_is_flat_too) {
  Image<float> depth(kAdaptiveMeshWidth, kAdaptiveMeshHeight);
  for (int i = 0; i < kAdaptiveMeshWidth * kAdaptiveMeshHeight; ++i) {
    depth.data()[i] = 1 / (0.5F - 0.004F * static_cast<float>(i % kAdaptiveMeshWidth));
  }
  const auto triangles = triangles_of(depth);
  EXPECT_EQ(cells_covered(triangles), (kAdaptiveMeshWidth - 1) * (kAdaptiveMeshHeight - 1));
  EXPECT_EQ(triangles.size(), 4U * 3U * 2U);
}

TEST_F(AdaptiveMeshTest, what_is_bent_gets_small_triangles_and_still_covers_everything) {
  Image<float> depth(kAdaptiveMeshWidth, kAdaptiveMeshHeight, 2.0F);
  for (int y = 0; y < kAdaptiveMeshHeight; ++y) {
    for (int x = 0; x < kAdaptiveMeshWidth; ++x) {
      const float from_middle = static_cast<float>(std::abs(x - 40));
      if (from_middle < 12) depth.at(x, y) = 2.0F - 0.03F * (12 - from_middle);
    }
  }
  const auto triangles = triangles_of(depth);
  EXPECT_EQ(cells_covered(triangles), (kAdaptiveMeshWidth - 1) * (kAdaptiveMeshHeight - 1));
  EXPECT_GT(triangles.size(), 24U);
  EXPECT_LT(triangles.size(), 2U * (kAdaptiveMeshWidth - 1) * (kAdaptiveMeshHeight - 1) / 3);
}

TEST_F(AdaptiveMeshTest, nothing_spans_a_break_or_a_missing_reading) {
  Image<float> depth(kAdaptiveMeshWidth, kAdaptiveMeshHeight, 3.0F);
  for (int y = 0; y < kAdaptiveMeshHeight; ++y) {
    for (int x = 0; x < 20; ++x) depth.at(x, y) = 1.5F;
  }
  depth.at(50, 30) = 0;
  for (const Triangle& t : triangles_of(depth)) {
    for (const GLuint i : t) {
      EXPECT_EQ(at_index(depth, i), at_index(depth, t[0]));
      EXPECT_GT(at_index(depth, i), 0);
    }
  }
}

TEST_F(AdaptiveMeshTest, what_lies_on_the_covering_surface_is_left_out) {
  const Image<float> wall(kAdaptiveMeshWidth, kAdaptiveMeshHeight, 3.0F);
  Image<float> live = wall;
  for (int y = 0; y < kAdaptiveMeshHeight; ++y) {
    for (int x = 33; x < 40; ++x) live.at(x, y) = y < 20 ? 1.5F : 0;  // a person; then no readings
  }
  const int covered = cells_covered(triangles_of(wall, &live));
  EXPECT_GE(covered, 6 * (kAdaptiveMeshHeight - 1));
  EXPECT_LE(covered, 16 * (kAdaptiveMeshHeight - 1))
      << "no more than the nodes that he stands before";
  EXPECT_TRUE(triangles_of(wall, &wall).empty());
}

TEST_F(AdaptiveMeshTest, before_an_unknown_background_only_what_moves_is_kept) {
  Result<AdaptiveMesher> mesher = AdaptiveMesher::create();
  ASSERT_TRUE(mesher.ok()) << mesher.error().message;
  const GlTexture unknown = texture_of({kAdaptiveMeshWidth, kAdaptiveMeshHeight, 0.0F});
  Image<Eigen::Vector4f> velocities(kAdaptiveMeshWidth, kAdaptiveMeshHeight,
                                    {0.1F, 0, 0, 0});  // too slow to be told from noise
  for (int y = 0; y < velocities.height(); ++y) {
    for (int x = 32; x < velocities.width(); ++x) velocities.at(x, y) = {0, 0.5F, 0, 0};
  }
  const GlTexture moving = make_texture(GL_RGBA16F, velocities.width(), velocities.height());
  glTextureSubImage2D(moving.name(), 0, 0, 0, velocities.width(), velocities.height(), GL_RGBA,
                      GL_FLOAT, velocities.data());
  const AdaptiveMesher::Covering covering{&unknown, true, &moving};
  const Image<float> person(kAdaptiveMeshWidth, kAdaptiveMeshHeight, 1.5F);
  const std::vector<Triangle> kept = triangles_of(person, covering, *mesher);
  EXPECT_EQ(cells_covered(kept), (kAdaptiveMeshWidth - 1 - 32) * (kAdaptiveMeshHeight - 1));
  for (const Triangle& t : kept) {
    for (const GLuint i : t) EXPECT_GE(column(i), 32);
  }
}

TEST_F(AdaptiveMeshTest, the_same_surface_gives_the_same_triangles) {
  Image<float> depth(kAdaptiveMeshWidth, kAdaptiveMeshHeight);
  for (int i = 0; i < kAdaptiveMeshWidth * kAdaptiveMeshHeight; ++i) {
    depth.data()[i] = 2 + 0.01F * static_cast<float>(i * 7919 % 13);
  }
  EXPECT_EQ(triangles_of(depth), triangles_of(depth));
}

TEST_F(AdaptiveMeshTest, without_readings_there_is_nothing) {
  EXPECT_TRUE(triangles_of(Image<float>(kAdaptiveMeshWidth, kAdaptiveMeshHeight, 0.0F)).empty());
}

}  // namespace
}  // namespace roomcast::render
