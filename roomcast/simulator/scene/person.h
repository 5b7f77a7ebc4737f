// SPDX-License-Identifier: Apache-2.0
// Who is in a room: how somebody is built and dressed, what they carry, and what they do. Plain
// data; performance.h turns it into motion. Metres, seconds, radians; world frame of room.h.
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
  float girth = 1.0F;  // how stout; 1: slim to average
  HairStyle hair = HairStyle::kShort;
  float hem_m = 0.08F;   // how far the shirt hangs below the hips' joints; a coat: 0.4
  float sleeve = 0.92F;  // share of the forearm that is covered; negative: of the upper arm, bare
};

/// What somebody wears and is, each an index into Room::surfaces.
struct Outfit {
  SurfaceIndex shirt = 0, trousers = 0, shoes = 0, skin = 0, hair = 0, face = 0;
};

/// What somebody does where they stop.
enum class Activity : std::uint8_t {
  kStand,     // breathes, sways, looks around a little
  kSit,       // sits down, rests, stands up
  kTalk,      // gestures with both hands, standing
  kSitTalk,   // gestures, sitting
  kType,      // sits, both hands at the target, typing
  kReach,     // moves the right hand to the target and back
  kWrite,     // writes about the target with the right hand
  kPlug,      // bends or crouches and works at the target with the right hand
  kExercise,  // squats and sweeps both arms up and down, turning to and fro, standing
  kStretch,   // bends down and comes up again, slowly, arms ahead
  kTakeUp,    // takes the burden, which rests at the target, with both hands
  kPutDown,   // leaves the burden at the target
};

struct Waypoint {
  Eigen::Vector2f at_m = Eigen::Vector2f::Zero();  // x, z of the point between the feet
  float heading_rad = 0;                           // 0: facing +z; a quarter turn: facing +x
  float stay_s = 2;
  Activity activity = Activity::kStand;
  /// Where a hand goes, or where the burden's middle rests (its front towards the person). With
  /// kStand, kTalk and kSitTalk: what is looked at.
  Eigen::Vector3f target_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f seat_m = Eigen::Vector3f::Zero();  // middle of the seat's top, of those who sit
  std::vector<Eigen::Vector2f> via_m;                // on the way here from the stop before
};

/// Something carried with both hands, held at its sides. Local frame: y up, its front towards +z,
/// the origin in its middle.
struct Burden {
  TriangleMesh mesh;
  Eigen::Vector3f half_size_m = Eigen::Vector3f::Constant(0.15F);
};

/// Goes from stop to stop and round again. With a single stop: stays and does one thing for ever.
struct Person {
  Build build;
  Outfit outfit;
  std::vector<Waypoint> stops;
  float pace_m_s = 1.05F;
  float begin_s = 0;             // how far into the round they are at scene time 0
  std::optional<Burden> burden;  // rests where the last kPutDown left it
};

}  // namespace roomcast::simulator
