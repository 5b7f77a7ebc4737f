// SPDX-License-Identifier: Apache-2.0
// FloorPlan: allocates space in a room to furniture, wall objects, walking paths and sensor views.
// Positions are drawn at random and accepted if they are free, so a seed determines a layout
// without collisions. Metres, radians; world frame of room.h, plan coordinates are (x, z).
// Single-threaded.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/scene/footprint.h"
#include "roomcast/simulator/scene/room.h"

namespace roomcast::simulator {

inline constexpr int kAnyWall = -1;

class FloorPlan {
 public:
  FloorPlan(const Eigen::Vector3f& room_size_m, std::uint32_t seed);

  /// Keeps the strip between two points free of furniture.
  void keep_way(const Eigen::Vector2f& from_m, const Eigen::Vector2f& to_m, float half_width_m);
  /// Keeps tall objects away from a sensor and from the space close in front of it.
  void keep_view(const SensorMount& mount);

  /// Allocates a place of this size (width, height, depth) and returns its frame on the floor, with
  /// the front towards +z. `front_m`: depth kept free in front. Nothing if there is no space.
  std::optional<Eigen::Affine3f> against_wall(const Eigen::Vector3f& size_m, float front_m,
                                              int wall = kAnyWall);
  std::optional<Eigen::Affine3f> in_corner(const Eigen::Vector3f& size_m);
  std::optional<Eigen::Affine3f> in_the_open(const Eigen::Vector3f& size_m);
  /// Allocates exactly this place if it is free.
  bool take(const Eigen::Affine3f& at, const Eigen::Vector3f& size_m);
  [[nodiscard]] bool is_free(const Footprint& footprint) const;

  /// Allocates a piece of wall of this size (width, height, depth); returns the frame of
  /// furniture.h's on_wall.
  std::optional<Eigen::Affine3f> on_wall_at(const Eigen::Vector3f& size_m, float middle_height_m,
                                            int wall = kAnyWall);

  /// The footprints of everything on the floor.
  [[nodiscard]] const std::vector<Footprint>& taken() const { return taken_; }

 private:
  struct WallPatch {
    int wall;
    float left_m, right_m, bottom_m, top_m;
  };
  [[nodiscard]] float wall_length(int wall) const { return wall < 2 ? size_m_.z() : size_m_.x(); }
  [[nodiscard]] bool wall_is_free(const WallPatch& patch) const;
  [[nodiscard]] Eigen::Affine3f by_wall(int wall, float along_m, float out_m) const;
  std::optional<Eigen::Affine3f> try_wall(const Eigen::Vector3f& size_m, float front_m, int wall,
                                          float along_m);

  Eigen::Vector3f size_m_;
  Random random_;
  std::vector<Footprint> taken_, ways_;
  struct Clearing {
    Footprint area;
    float lowest_m;  // lower objects do not conflict
  };
  std::vector<Clearing> views_;
  std::vector<WallPatch> wall_patches_;
};

}  // namespace roomcast::simulator
