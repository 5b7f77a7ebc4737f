// SPDX-License-Identifier: Apache-2.0
// Furnisher: adds furniture to a room where its floor plan has space, with sizes and accessories
// drawn at random. Pieces without space are omitted. Metres; single-threaded.
#pragma once

#include <optional>

#include "roomcast/simulator/random/random.h"
#include "roomcast/simulator/scene/floor_plan.h"
#include "roomcast/simulator/scene/furniture.h"
#include "roomcast/simulator/scene/palette.h"

namespace roomcast::simulator {

class Furnisher {
 public:
  using Place = std::optional<Eigen::Affine3f>;

  /// All three arguments must outlive the Furnisher.
  Furnisher(Room& room, FloorPlan& plan, Random& random)
      : room_(room), plan_(plan), random_(random), palette_(draw_palette(room, random)) {}

  [[nodiscard]] const Palette& palette() const { return palette_; }

  // Living rooms. Frames are those of furniture.h.
  Place sofa(float front_m);
  Place coffee_table_before(const Eigen::Affine3f& sofa);
  void rug_under(const Eigen::Vector2f& middle_m, const Eigen::Vector2f& size_m);
  Place dining_table();
  Place television();
  Place sideboard();
  Place bookshelf(float front_m = 0.0F);
  Place wardrobe();
  Place armchair();
  void plant();
  void floor_lamp();
  void odds_and_ends(int count);  // crates, stools, balls, bins, a bicycle

  // Offices and laboratories.
  /// Returns the desk's frame; the chair in front of it is turned away unless `pulled_up`.
  Place desk(bool pulled_up, float front_m = 0.0F);
  Place rack();
  Place lab_bench(float front_m, bool equipped);
  Place cabinet();

  // Walls and ceilings.
  void window(int wall = kAnyWall);
  void door();
  void pictures(int count);
  void clock();
  Place whiteboard(float front_m);
  Place wall_screen();
  /// A lamp at the centre of the ceiling.
  void pendant();
  /// Luminous panels that light the room.
  void panels();

  /// Puts objects on a top of `size_m` (width, depth) whose centre is the frame's origin.
  void set_out(const Eigen::Affine3f& on_top, const Eigen::Vector2f& size_m, int count);
  void monitor_and_keyboard(const Eigen::Affine3f& on_top);

 private:
  void picture_on(const Eigen::Affine3f& at, const Eigen::Vector2f& size_m);
  void odd_end(int which);

  Room& room_;
  FloorPlan& plan_;
  Random& random_;
  Palette palette_;
};

/// The centre of a sofa's seat, and the standing position in front of it.
struct Seat {
  Eigen::Vector3f seat_m;
  Eigen::Vector2f stand_m;
  float heading_rad;
};
[[nodiscard]] Seat seat_of_sofa(const Eigen::Affine3f& sofa, float along_m);
[[nodiscard]] Seat seat_of_chair(const Eigen::Affine3f& chair, float height_m);

}  // namespace roomcast::simulator
