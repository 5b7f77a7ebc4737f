// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/moving_things.h"

#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "roomcast/simulator/people/body_skin.h"
#include "roomcast/simulator/people/moving_picture.h"
#include "roomcast/simulator/tracing/ray_scene.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector3f;
using std::chrono::milliseconds;

Room test_room() {
  return build_room("livingroom", 1).value();
}

TEST(MovingThings, an_instant_does_not_depend_on_earlier_instants) {
  const Room room = test_room();
  MovingThings first(room), second(room);
  for (int i = 0; i < 5; ++i) second.move_to(milliseconds(317 * i));
  first.move_to(milliseconds(2500));
  second.move_to(milliseconds(2500));
  EXPECT_EQ(first.mesh().positions, second.mesh().positions);
  EXPECT_EQ(first.mesh().normals, second.mesh().normals);
}

TEST(MovingThings, at_speed_zero_nothing_ever_moves_and_at_half_speed_half_as_far) {
  const Room room = test_room();
  MovingThings still(room, 0.0), half(room, 0.5), whole(room);
  const auto start = still.mesh().positions;
  still.move_to(milliseconds(98765));
  EXPECT_EQ(still.mesh().positions, start);
  half.move_to(milliseconds(3000));
  whole.move_to(milliseconds(1500));
  EXPECT_EQ(half.mesh().positions, whole.mesh().positions);
}

TEST(MovingThings, boxes_hold_their_parts_and_parts_hold_everything) {
  MovingThings things(test_room());
  things.move_to(milliseconds(4321));
  std::size_t vertices = 0, triangles = 0;
  for (const MovingPart& part : things.parts()) {
    vertices += part.vertex_count;
    triangles += part.triangle_count;
    for (std::uint32_t i = 0; i < part.vertex_count; ++i)
      ASSERT_TRUE(part.box_m.contains(things.mesh().positions[part.first_vertex + i]));
    for (std::uint32_t i = 0; i < part.triangle_count; ++i) {
      for (const auto corner : things.mesh().triangles[part.first_triangle + i]) {
        ASSERT_GE(corner, part.first_vertex);
        ASSERT_LT(corner, part.first_vertex + part.vertex_count);
      }
    }
  }
  EXPECT_EQ(vertices, things.mesh().positions.size());
  EXPECT_EQ(triangles, things.mesh().triangles.size());
  EXPECT_EQ(things.openness().size(), vertices);
}

TEST(BodySkin, is_closed_and_as_tall_as_its_build_says) {
  Build build;
  build.height_m = 1.70F;
  const BodySkin skin(build, Outfit{}, measures_of(build));
  using Point = std::tuple<float, float, float>;
  std::map<std::pair<Point, Point>, int> edges;
  float top = 0.0F, bottom = 1.0F;
  for (const auto& triangle : skin.mesh().triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3f& a = skin.mesh().positions[triangle[i]];
      const Vector3f& b = skin.mesh().positions[triangle[(i + 1) % 3]];
      const Point from(a.x(), a.y(), a.z()), to(b.x(), b.y(), b.z());
      if (from == to) continue;
      ++edges[{from, to}];
      --edges[{to, from}];
      top = std::max(top, a.y());
      bottom = std::min(bottom, a.y());
    }
  }
  for (const auto& [edge, balance] : edges) ASSERT_EQ(balance, 0);
  EXPECT_NEAR(top, build.height_m, 0.05F);
  EXPECT_NEAR(bottom, 0.0F, 0.005F);
}

PlacedCamera camera_at(const Vector3f& eye_m, const Vector3f& target_m) {
  CameraIntrinsics lens;
  lens.width = 256;
  lens.height = 212;
  lens.fx = lens.fy = 270.0;
  lens.cx = 128.0;
  lens.cy = 106.0;
  lens.k1 = 0.09;
  lens.k2 = -0.27;
  return {lens, world_from_optical_looking_at(eye_m.cast<double>(), target_m.cast<double>())};
}

TEST(MovingLayer, equals_ray_casting_through_a_distorting_lens) {
  const Room room = test_room();
  MovingThings things(room);
  MovingLayer layer(256, 212);
  for (const int time_ms : {0, 900, 4100}) {
    things.move_to(milliseconds(time_ms));
    const Vector3f middle = things.parts().front().box_m.center();
    const PlacedCamera camera = camera_at(middle + Vector3f(1.6F, 0.6F, 0.8F), middle);
    layer.draw(things, camera);
    const auto scene = *RayScene::build(things.mesh());
    int hits = 0, differing = 0;
    for (int y = 0; y < camera.height(); ++y) {
      for (int x = 0; x < camera.width(); ++x) {
        const auto hit = scene->first_hit(camera.eye_m(), camera.direction(x, y));
        const float z = layer.z_m().at(x, y);
        hits += hit ? 1 : 0;
        const bool same = hit ? std::abs(hit->t - z) < 0.0005F : std::isinf(z);
        differing += same ? 0 : 1;
      }
    }
    EXPECT_GT(hits, 3000);
    EXPECT_LE(differing, 4) << "of " << hits;  // rays along an edge
  }
}

TEST(MovingLayer, is_empty_again_when_they_are_out_of_sight) {
  const Room room = test_room();
  const MovingThings things(room);
  const Vector3f middle = things.parts().front().box_m.center();
  MovingLayer layer(256, 212);
  layer.draw(things, camera_at(middle + Vector3f(2, 0, 0), middle));
  layer.draw(things, camera_at(middle + Vector3f(2, 0, 0), middle + Vector3f(4, 0, 0)));
  for (int y = 0; y < 212; ++y)
    for (int x = 0; x < 256; ++x) ASSERT_TRUE(std::isinf(layer.z_m().at(x, y)));
}

TEST(MovingLayer, points_lie_on_the_surface_and_face_the_camera) {
  const Room room = test_room();
  const MovingThings things(room);
  const Vector3f middle = things.parts().front().box_m.center();
  const PlacedCamera camera = camera_at(middle + Vector3f(0, 0.3F, 2), middle);
  MovingLayer layer(256, 212);
  layer.draw(things, camera);
  int seen = 0;
  for (int y = 0; y < 212; y += 3) {
    for (int x = 0; x < 256; x += 3) {
      if (std::isinf(layer.z_m().at(x, y))) continue;
      const MovingPoint point = moving_point(things, layer, camera, x, y);
      EXPECT_NEAR(point.normal.norm(), 1.0F, 1e-4F);
      EXPECT_LT(point.surface, room.surfaces.size());
      EXPECT_NEAR(camera.axes().col(2).dot(point.position_m - camera.eye_m()), layer.z_m().at(x, y),
                  1e-4F);
      ++seen;
    }
  }
  EXPECT_GT(seen, 200);
}

TEST(MovingColors, people_are_lit_and_look_the_same_when_drawn_again_after_another_instant) {
  const Room room = test_room();
  MovingThings things(room);
  const SurfaceTexels texels(room, things);
  const auto scene = *RayScene::build(room.mesh);
  const Vector3f middle = things.parts().front().box_m.center();
  const PlacedCamera camera = camera_at(middle + Vector3f(0.9F, 0.3F, 1.2F), middle);
  const ColorPlate plate = trace_color_plate(room, *scene, camera, 1);
  MovingLayer layer(256, 212);
  MovingColors colors;
  const auto picture_at = [&](nanoseconds time) {
    ColorImage picture = plate.color;
    things.move_to(time);
    layer.draw(things, camera);
    colors.light(things, room);
    colors.put(things, layer, plate, texels, picture.view());
    return picture;
  };
  const ColorImage first = picture_at(milliseconds(0));
  double sum = 0;
  int count = 0, bright = 0;
  for (int y = 0; y < 212; ++y) {
    for (int x = 0; x < 256; ++x) {
      if (!is_in_front(layer, plate.z_m, x, y)) continue;
      const Rgb8 pixel = first.at(x, y);
      sum += pixel.r + pixel.g + pixel.b;
      bright += pixel.r + pixel.g + pixel.b > 60 ? 1 : 0;
      ++count;
    }
  }
  EXPECT_GT(count, 2000);
  EXPECT_GT(sum / count, 120);
  EXPECT_LT(sum / count, 600);
  EXPECT_GT(bright, count / 2);
  EXPECT_NE(picture_at(milliseconds(1500)), first);
  EXPECT_EQ(picture_at(milliseconds(0)), first);
}

TEST(FloorShade, is_dark_under_the_feet_and_gone_far_away) {
  const Room room = test_room();
  const MovingThings things(room);
  FloorShade shade;
  shade.work_out(things.shade_balls(), room);
  float darkest = 1.0F;
  for (const ShadeBall& ball : things.shade_balls())
    darkest = std::min(darkest, shade.display_left(ball.centre_m.x(), ball.centre_m.z()));
  EXPECT_LT(darkest, 0.78F);
  EXPECT_GT(darkest, 0.22F);
  EXPECT_GT(shade.display_left(shade.area_m().min().x(), shade.area_m().min().y()), 0.9F);
}

}  // namespace
}  // namespace roomcast::simulator
