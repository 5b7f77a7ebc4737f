// SPDX-License-Identifier: Apache-2.0
// Person: a person's build, clothes, burden and activities. Plain data; performance.h turns it into
// motion. Metres, seconds, radians; world frame of room.h.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "roomcast/simulator/scene/triangle_mesh.h"

namespace roomcast::simulator {

enum class HairStyle : std::uint8_t { kShort, kLong, kBun, kCurly };

struct Build {
  float height_m = 1.78F;
  float girth = 1.0F;  // 1: slim to average
  HairStyle hair = HairStyle::kShort;
  float hem_m = 0.08F;   // length of the shirt below the hip joints; a coat: 0.4
  float sleeve = 0.92F;  // covered share of the forearm; negative: of the upper arm, forearm bare
};

/// A person's clothes, skin and hair, each an index into Room::surfaces.
struct Outfit {
  SurfaceIndex shirt = 0, trousers = 0, shoes = 0, skin = 0, hair = 0, face = 0;
};

/// Activity at a waypoint.
enum class Activity : std::uint8_t {
  kStand,     // breathes, sways, looks around a little
  kSit,       // sits down, rests, stands up
  kTalk,      // stands and gestures with both hands
  kSitTalk,   // sits and gestures
  kType,      // sits and types with both hands at the target
  kReach,     // moves the right hand to the target and back
  kWrite,     // writes around the target with the right hand
  kPlug,      // bends or crouches and works at the target with the right hand
  kExercise,  // squats, sweeps both arms up and down and turns to and fro, standing
  kStretch,   // bends down and comes up again slowly, arms forward
  kTakeUp,    // takes the burden from the target with both hands
  kPutDown,   // puts the burden down at the target
};

struct Waypoint {
  Eigen::Vector2f at_m = Eigen::Vector2f::Zero();  // x, z of the point between the feet
  float heading_rad = 0;                           // 0: facing +z; a quarter turn: facing +x
  float stay_s = 2;
  Activity activity = Activity::kStand;
  /// Target of a hand, or the centre of the resting burden (its front towards the person). With
  /// kStand, kTalk and kSitTalk: target of the gaze.
  Eigen::Vector3f target_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f seat_m = Eigen::Vector3f::Zero();  // seat's top centre, if seated
  std::vector<Eigen::Vector2f> via_m;                // points on the path to this waypoint
};

/// An object carried with both hands, held at its sides. Local frame: y up, front towards +z,
/// origin at its centre.
struct Burden {
  TriangleMesh mesh;
  Eigen::Vector3f half_size_m = Eigen::Vector3f::Constant(0.15F);
};

/// Goes from waypoint to waypoint in a cycle. With a single waypoint: stays there permanently.
struct Person {
  Build build;
  Outfit outfit;
  std::vector<Waypoint> stops;
  float pace_m_s = 1.05F;
  float begin_s = 0;             // time within the round at scene time 0
  std::optional<Burden> burden;  // rests where the last kPutDown left it
};

}  // namespace roomcast::simulator
