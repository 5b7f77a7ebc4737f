// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/scene/room.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "roomcast/simulator/people/moving_things.h"
#include "roomcast/simulator/people/performance.h"

namespace roomcast::simulator {
namespace {

using testing::HasSubstr;

class Rooms : public testing::TestWithParam<std::string_view> {
 protected:
  Room room_ = build_room(GetParam(), 1).value();
};
std::string test_name_of(const testing::TestParamInfo<std::string_view>& scene) {
  std::string name(scene.param);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Scenes, Rooms, testing::ValuesIn(kSceneNames), test_name_of);
INSTANTIATE_TEST_SUITE_P(HarshScenes, Rooms, testing::ValuesIn(kHarshSceneNames), test_name_of);

TEST_P(Rooms, triangles_have_known_vertices_and_surfaces) {
  const TriangleMesh& mesh = room_.mesh;
  ASSERT_EQ(mesh.positions.size(), mesh.normals.size());
  ASSERT_EQ(mesh.positions.size(), mesh.uv_m.size());
  ASSERT_EQ(mesh.triangles.size(), mesh.surface.size());
  for (const auto& triangle : mesh.triangles) {
    for (const auto corner : triangle) ASSERT_LT(corner, mesh.positions.size());
  }
  for (const auto surface : mesh.surface) ASSERT_LT(surface, room_.surfaces.size());
}

TEST_P(Rooms, everything_is_inside_the_walls) {
  constexpr float kSlack_m = 0.06F;    // lamps extend into the ceiling
  constexpr float kTilted_m = 0.008F;  // ends of slanted bars
  const Eigen::Vector3f half = 0.5F * room_.size_m + Eigen::Vector3f::Constant(kSlack_m);
  for (const auto& point : room_.mesh.positions) {
    ASSERT_TRUE(point.allFinite());
    ASSERT_LE(std::abs(point.x()), half.x());
    ASSERT_LE(std::abs(point.z()), half.z());
    ASSERT_GE(point.y(), -kTilted_m);
    ASSERT_LE(point.y(), room_.size_m.y() + kSlack_m);
  }
}

/// True if a point is near a seat on which the person sits down.
bool near_own_seat(const Person& person, const Eigen::Vector3f& point) {
  return std::any_of(person.stops.begin(), person.stops.end(), [&](const Waypoint& stop) {
    return stop.activity == Activity::kSit && (stop.seat_m - point).norm() < 1.3F;
  });
}

TEST_P(Rooms, people_keep_clear_of_the_furniture) {
  constexpr float kHips_m = 0.2F;
  constexpr float kRug_m = 0.02F, kHead_m = 1.8F;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Room room = build_room(GetParam(), seed).value();
    for (const Person& person : room.people) {
      if (person.stops.size() == 1) continue;  // seated permanently on their chair
      const Itinerary itinerary(person.stops, person.pace_m_s);
      for (float time_s = 0; time_s < itinerary.period_s(); time_s += 0.25F) {
        const Eigen::Vector2f at = itinerary.place_at(time_s).at_m;
        for (const auto& point : room.mesh.positions) {
          if (point.y() < kRug_m || point.y() > kHead_m || near_own_seat(person, point)) continue;
          ASSERT_GT(std::hypot(point.x() - at.x(), point.z() - at.y()), kHips_m)
              << point.transpose() << " at " << time_s << " seed " << seed;
        }
      }
    }
  }
}

TEST_P(Rooms, pieces_of_furniture_do_not_overlap) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Room room = build_room(GetParam(), seed).value();
    ASSERT_GE(room.footprints.size(), 3U);
    for (std::size_t a = 0; a < room.footprints.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        ASSERT_FALSE(overlap(room.footprints[a], room.footprints[b], 0.0F)) << "seed " << seed;
  }
}

TEST_P(Rooms, the_same_seed_is_the_same_room_and_another_seed_another_layout) {
  const Room again = build_room(GetParam(), 1).value();
  EXPECT_EQ(room_.mesh.positions, again.mesh.positions);
  EXPECT_EQ(room_.mesh.normals, again.mesh.normals);
  EXPECT_EQ(room_.mesh.uv_m, again.mesh.uv_m);
  EXPECT_EQ(room_.mesh.triangles, again.mesh.triangles);
  EXPECT_EQ(room_.mesh.surface, again.mesh.surface);
  const Room other = build_room(GetParam(), 2).value();
  EXPECT_NE(room_.mesh.positions, other.mesh.positions);
  EXPECT_NE(room_.sensor_mounts[0].eye_m, other.sensor_mounts[0].eye_m);
  int elsewhere = 0;
  for (std::size_t i = 0; i < std::min(room_.footprints.size(), other.footprints.size()); ++i) {
    const Eigen::Vector2f moved = room_.footprints[i].centre_m - other.footprints[i].centre_m;
    elsewhere += moved.norm() > 0.1F ? 1 : 0;
  }
  const bool rows = GetParam() == "mirror-tiles" || GetParam() == "shelf-rows" ||
                    GetParam() == "desk-rows";  // what stands in rows is placed as rows
  EXPECT_GE(elsewhere, rows ? 0 : 3);
}

TEST_P(Rooms, no_sensor_is_inside_furniture) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Room room = build_room(GetParam(), seed).value();
    for (const SensorMount& mount : room.sensor_mounts) {
      for (const auto& point : room.mesh.positions)
        ASSERT_GT((point - mount.eye_m).norm(), 0.12F) << "seed " << seed;
      for (const Footprint& taken : room.footprints) {
        if (taken.height_m < mount.eye_m.y()) continue;
        ASSERT_FALSE(contains(taken, {mount.eye_m.x(), mount.eye_m.z()})) << "seed " << seed;
      }
    }
  }
}

TEST_P(Rooms, has_people_whose_clothes_have_known_surfaces) {
  ASSERT_FALSE(room_.people.empty());
  for (const Person& person : room_.people) {
    const Outfit& worn = person.outfit;
    for (const auto surface :
         {worn.shirt, worn.trousers, worn.shoes, worn.skin, worn.hair, worn.face})
      EXPECT_LT(surface, room_.surfaces.size());
    EXPECT_FALSE(person.stops.empty());
  }
}

TEST_P(Rooms, sensors_stand_inside_at_sensible_heights) {
  for (const SensorMount& mount : room_.sensor_mounts) {
    EXPECT_GE(mount.eye_m.y(), 1.2F);
    EXPECT_LE(mount.eye_m.y(), 2.2F);
    EXPECT_LT(std::abs(mount.eye_m.x()), 0.5F * room_.size_m.x());
    EXPECT_LT(std::abs(mount.eye_m.z()), 0.5F * room_.size_m.z());
  }
}

TEST(Room, the_floor_of_mirror_tiles_repeats_exactly_and_is_its_own_mirror_image) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Room room = build_room("mirror-tiles", seed).value();
    const Surface& floor = room.surfaces[room.mesh.surface.front()];
    ASSERT_EQ(floor.pattern, Pattern::kTiles);
    const Eigen::Vector2f tile = floor.size_m;
    const float columns = room.size_m.x() / tile.x();
    EXPECT_NEAR(columns, std::round(columns), 1e-3F);
    for (int i = 0; i < 200; ++i) {
      const Eigen::Vector2f at(0.0137F * static_cast<float>(i), 0.0101F * static_cast<float>(i));
      const auto here = albedo_at(floor, at, 0.004F);
      const Eigen::Vector2f further = at + Eigen::Vector2f(3.0F * tile.x(), tile.y());
      const Eigen::Vector2f mirrored(4.0F * tile.x() - at.x(), at.y());
      EXPECT_LT((albedo_at(floor, further, 0.004F) - here).norm(), 1e-3F);
      EXPECT_LT((albedo_at(floor, mirrored, 0.004F) - here).norm(), 1e-3F);
    }
  }
}

TEST(Room, mirror_tiles_without_anything_unique_is_its_own_half_turn) {
  int symmetric = 0, with_something = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Room room = build_room("mirror-tiles", seed).value();
    if (room.unique_things != 0) {
      ++with_something;
      continue;
    }
    ++symmetric;
    const auto key = [](float x, float y, float z) {
      const auto cell = [](float value) { return std::lround(value * 200.0F); };
      return std::array<long, 3>{cell(x), cell(y), cell(z)};
    };
    std::set<std::array<long, 3>> cells;
    for (const auto& p : room.mesh.positions) cells.insert(key(p.x(), p.y(), p.z()));
    for (const auto& p : room.mesh.positions) {
      bool found = false;
      for (const float dx : {-0.002F, 0.0F, 0.002F})
        for (const float dz : {-0.002F, 0.0F, 0.002F})
          found = found || cells.count(key(-p.x() + dx, p.y(), -p.z() + dz)) > 0;
      ASSERT_TRUE(found) << p.transpose();
    }
  }
  EXPECT_GT(symmetric, 0);
  EXPECT_GT(with_something, 0);
}

/// How often a place of the mesh occurs again at this shift, and after half a turn.
struct Repetition {
  std::size_t shifted = 0, turned = 0, places = 0;
};

Repetition repetition_of(const Room& room, float shift_x_m) {
  const auto key = [](float x, float y, float z) {
    const auto cell = [](float value) { return std::lround(value * 100.0F); };
    return std::array<long, 3>{cell(x), cell(y), cell(z)};
  };
  std::set<std::array<long, 3>> cells;
  for (const auto& p : room.mesh.positions) cells.insert(key(p.x(), p.y(), p.z()));
  Repetition found;
  const auto near = [&](float x, float y, float z) {
    for (const float dx : {-0.01F, 0.0F, 0.01F}) {
      for (const float dz : {-0.01F, 0.0F, 0.01F}) {
        if (cells.contains(key(x + dx, y, z + dz))) return true;
      }
    }
    return false;
  };
  for (const auto& p : room.mesh.positions) {
    ++found.places;
    found.shifted += near(p.x() + shift_x_m, p.y(), p.z());
    found.turned += near(-p.x(), p.y(), -p.z());
  }
  return found;
}

TEST(Room, rows_repeat_from_piece_to_piece) {
  for (const char* name : {"shelf-rows", "desk-rows"}) {
    const Room room = build_room(name, 3).value();
    ASSERT_GE(room.footprints.size(), 6U) << name;
    std::size_t most = 0, places = 1;
    for (const Footprint& other : room.footprints) {
      const Eigen::Vector2f shift = other.centre_m - room.footprints.front().centre_m;
      if (std::abs(shift.y()) > 0.01F || std::abs(shift.x()) < 0.1F) continue;
      const Repetition found = repetition_of(room, shift.x());
      most = std::max(most, found.shifted);
      places = found.places;
    }
    EXPECT_GT(static_cast<double>(most) / static_cast<double>(places), 0.4) << name;
  }
}

TEST(Room, a_half_turn_hall_looks_alike_after_half_a_turn) {
  int with_something = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Room room = build_room("half-turn-hall", seed).value();
    const Repetition found = repetition_of(room, 0);
    with_something += room.unique_things > 0;
    const double same = static_cast<double>(found.turned) / static_cast<double>(found.places);
    if (room.unique_things == 0) {
      EXPECT_GT(same, 0.97) << seed;
    } else {
      EXPECT_GT(same, 0.3) << seed;
    }
  }
  EXPECT_GT(with_something, 0);
}

TEST(Room, the_walls_of_an_open_plan_are_out_of_reach) {
  const Room room = build_room("open-plan", 1).value();
  for (const SensorMount& mount : room.sensor_mounts) {
    const Eigen::Vector3f ahead = (mount.target_m - mount.eye_m).normalized();
    const float to_x = 0.5F * room.size_m.x() - mount.eye_m.x() * (ahead.x() > 0 ? 1.0F : -1.0F);
    const float to_z = 0.5F * room.size_m.z() - mount.eye_m.z() * (ahead.z() > 0 ? 1.0F : -1.0F);
    EXPECT_GT(std::min(to_x / std::abs(ahead.x()), to_z / std::abs(ahead.z())), 8.0F);
  }
}

TEST(Room, bad_floors_return_little_light) {
  for (const char* name : {"glossy-floor", "dark-floor"}) {
    const Room room = build_room(name, 1).value();
    const Surface& floor = room.surfaces[room.mesh.surface.front()];
    EXPECT_LT(infrared_back(floor, 0.5F), 0.1F) << name;
  }
}

TEST(Room, no_name_is_the_living_room) {
  EXPECT_EQ(build_room("", 1)->name, "livingroom");
}

TEST(Room, unknown_scene_is_refused_with_a_list_of_scenes) {
  const auto room = build_room("kitchen", 1);
  ASSERT_FALSE(room);
  EXPECT_EQ(room.error().code, ErrorCode::kNotFound);
  EXPECT_THAT(room.error().message, HasSubstr("kitchen"));
  for (const auto name : kSceneNames)
    EXPECT_THAT(room.error().message, HasSubstr(std::string(name)));
}

}  // namespace
}  // namespace roomcast::simulator
