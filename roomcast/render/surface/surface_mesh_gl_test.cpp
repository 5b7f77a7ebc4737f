// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <vector>

#include "roomcast/render/gl/gl_fixture.h"
#include "roomcast/render/surface/sensor_pictures_fixture.h"
#include "roomcast/render/surface/surface_mesh.h"

namespace roomcast::render {
namespace {

using Triangle = std::array<GLuint, 3>;

class SurfaceMeshTest : public GlTest {
 protected:
  // The triangles with an area above zero.
  std::vector<Triangle> triangles_of(const CameraIntrinsics& lens, const SensorPictures& pictures,
                                     const SurfaceMeshOptions& options = {}) {
    Result<SensorSurface> surface = SensorSurface::create(lens);
    Result<SurfaceMesher> mesher = SurfaceMesher::create();
    EXPECT_TRUE(surface.ok() && mesher.ok());
    EXPECT_TRUE(surface->upload(pictures.depth_mm, pictures.color, pictures.seen).ok());
    SurfaceMesh mesh;
    mesher->update(*surface, options, mesh);
    return read_back(mesh);
  }

  static std::vector<Triangle> read_back(const SurfaceMesh& mesh) {
    std::vector<Triangle> slots(static_cast<std::size_t>(mesh.count) / 3);
    if (slots.empty()) return slots;
    glGetNamedBufferSubData(mesh.indices.name(), 0,
                            static_cast<GLsizeiptr>(slots.size() * sizeof(Triangle)), slots.data());
    std::erase_if(slots, [](const Triangle& t) { return t[0] == t[1]; });
    return slots;
  }
};

const CameraIntrinsics kFour = pinhole(2, 2, 2);
const CameraIntrinsics kGrid = pinhole(9, 7, 8);

SensorPictures corners(std::uint16_t z00, std::uint16_t z10, std::uint16_t z01, std::uint16_t z11) {
  SensorPictures pictures = wall(kFour, 0, kRed);
  pictures.depth_mm.at(0, 0) = z00;
  pictures.depth_mm.at(1, 0) = z10;
  pictures.depth_mm.at(0, 1) = z01;
  pictures.depth_mm.at(1, 1) = z11;
  return pictures;
}

TEST_F(SurfaceMeshTest, a_wall_gives_two_triangles_per_cell) {
  EXPECT_EQ(triangles_of(kGrid, wall(kGrid, 1000, kRed)).size(), 2U * 8 * 6);
}

TEST_F(SurfaceMeshTest, a_step_of_two_gives_four_times_fewer) {
  SurfaceMeshOptions options;
  options.grid_step = 2;
  EXPECT_EQ(triangles_of(kGrid, wall(kGrid, 1000, kRed), options).size(), 2U * 4 * 3);
}

TEST_F(SurfaceMeshTest, a_step_wider_than_the_picture_gives_none) {
  SurfaceMeshOptions options;
  options.grid_step = 16;
  EXPECT_TRUE(triangles_of(kGrid, wall(kGrid, 1000, kRed), options).empty());
}

TEST_F(SurfaceMeshTest, a_missing_corner_leaves_the_triangle_of_the_other_three) {
  using List = std::vector<Triangle>;
  EXPECT_EQ(triangles_of(kFour, corners(0, 1000, 1000, 1000)), (List{{1, 2, 3}}));
  EXPECT_EQ(triangles_of(kFour, corners(1000, 0, 1000, 1000)), (List{{0, 2, 3}}));
  EXPECT_EQ(triangles_of(kFour, corners(1000, 1000, 0, 1000)), (List{{0, 3, 1}}));
  EXPECT_EQ(triangles_of(kFour, corners(1000, 1000, 1000, 0)), (List{{0, 2, 1}}));
  EXPECT_TRUE(triangles_of(kFour, corners(1000, 0, 0, 1000)).empty());
}

// The largest gap is 1.2 cm + 2.2 % of 1 m = 34 mm.
TEST_F(SurfaceMeshTest, corners_further_apart_than_the_gap_are_not_joined) {
  EXPECT_EQ(triangles_of(kFour, corners(1000, 1000, 1033, 1033)).size(), 2U);
  EXPECT_TRUE(triangles_of(kFour, corners(1000, 1000, 1035, 1035)).empty());
}

TEST_F(SurfaceMeshTest, it_follows_the_newest_picture_and_the_options) {
  Result<SensorSurface> surface = SensorSurface::create(kGrid);
  Result<SurfaceMesher> mesher = SurfaceMesher::create();
  ASSERT_TRUE(surface.ok() && mesher.ok());
  SurfaceMesh mesh;
  mesher->update(*surface, {}, mesh);
  EXPECT_TRUE(read_back(mesh).empty()) << "no picture yet";

  const SensorPictures pictures = wall(kGrid, 1000, kRed);
  ASSERT_TRUE(surface->upload(pictures.depth_mm, pictures.color, pictures.seen).ok());
  mesher->update(*surface, {}, mesh);
  EXPECT_EQ(read_back(mesh).size(), 96U);

  const GLuint buffer = mesh.indices.name();
  SurfaceMeshOptions coarse;
  coarse.grid_step = 3;
  mesher->update(*surface, coarse, mesh);
  EXPECT_EQ(read_back(mesh).size(), 8U);
  mesher->update(*surface, {}, mesh);
  EXPECT_EQ(read_back(mesh).size(), 96U);
  EXPECT_EQ(mesh.indices.name(), buffer) << "a buffer that is large enough is kept";
}

}  // namespace
}  // namespace roomcast::render
