// SPDX-License-Identifier: Apache-2.0
#include "roomcast/simulator/people/moving_things.h"

#include "roomcast/simulator/people/body_skin.h"
#include "roomcast/simulator/people/performance.h"

namespace roomcast::simulator {
namespace {

using Eigen::Vector3f;

/// Appends a mesh; returns its run of vertices and triangles.
MovingPart appended(TriangleMesh& all, const TriangleMesh& more) {
  MovingPart part;
  part.first_vertex = static_cast<std::uint32_t>(all.positions.size());
  part.vertex_count = static_cast<std::uint32_t>(more.positions.size());
  part.first_triangle = static_cast<std::uint32_t>(all.triangles.size());
  part.triangle_count = static_cast<std::uint32_t>(more.triangles.size());
  all.positions.insert(all.positions.end(), more.positions.begin(), more.positions.end());
  all.normals.insert(all.normals.end(), more.normals.begin(), more.normals.end());
  all.uv_m.insert(all.uv_m.end(), more.uv_m.begin(), more.uv_m.end());
  all.surface.insert(all.surface.end(), more.surface.begin(), more.surface.end());
  for (const auto& t : more.triangles) {
    const auto first = part.first_vertex;
    all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return part;
}

void place_rigid(const TriangleMesh& local, const Eigen::Isometry3f& world_from_local,
                 TriangleMesh& out, std::size_t first) {
  for (std::size_t i = 0; i < local.positions.size(); ++i) {
    out.positions[first + i] = world_from_local * local.positions[i];
    out.normals[first + i] = world_from_local.linear() * local.normals[i];
  }
}

struct BallOnBone {
  Bone bone;
  float down_m, radius_m;
};

/// Occluders for shading: balls along the bones of a person of 1.80 m.
constexpr std::array<BallOnBone, 15> kBalls = {{{Bone::kPelvis, -0.03F, 0.15F},
                                                {Bone::kChest, -0.15F, 0.15F},
                                                {Bone::kChest, -0.34F, 0.16F},
                                                {Bone::kHead, -0.10F, 0.11F},
                                                {Bone::kLeftThigh, 0.22F, 0.09F},
                                                {Bone::kRightThigh, 0.22F, 0.09F},
                                                {Bone::kLeftShin, 0.0F, 0.065F},
                                                {Bone::kRightShin, 0.0F, 0.065F},
                                                {Bone::kLeftShin, 0.22F, 0.065F},
                                                {Bone::kRightShin, 0.22F, 0.065F},
                                                {Bone::kLeftFoot, 0.02F, 0.065F},
                                                {Bone::kRightFoot, 0.02F, 0.065F},
                                                {Bone::kLeftForearm, 0.05F, 0.05F},
                                                {Bone::kRightForearm, 0.05F, 0.05F},
                                                {Bone::kPelvis, 0.08F, 0.13F}}};
constexpr std::size_t kToeBalls = 2;

}  // namespace

struct MovingThings::MovingPerson {
  Performance performance;
  BodySkin skin;
  TriangleMesh burden;
  float burden_radius_m = 0;
  std::uint32_t first_vertex = 0, burden_vertex = 0;
  std::size_t first_part = 0, first_ball = 0;
};

MovingThings::MovingThings(const Room& room, double speed) : speed_(speed) {
  for (const Person& person : room.people) {
    Performance performance(person);
    BodySkin skin(person.build, person.outfit, performance.measures());
    MovingPerson moving{std::move(performance), std::move(skin), {}, 0, 0, 0, 0, 0};
    moving.first_part = parts_.size();
    moving.first_ball = shade_balls_.size();
    moving.first_vertex = appended(mesh_, moving.skin.mesh()).first_vertex;
    const auto first_triangle =
        static_cast<std::uint32_t>(mesh_.triangles.size() - moving.skin.mesh().triangles.size());
    openness_.insert(openness_.end(), moving.skin.openness().begin(), moving.skin.openness().end());
    for (MovingPart piece : moving.skin.pieces()) {
      piece.first_vertex += moving.first_vertex;
      piece.first_triangle += first_triangle;
      parts_.push_back(piece);
    }
    shade_balls_.resize(shade_balls_.size() + kBalls.size() + kToeBalls);
    if (person.burden) {
      moving.burden = person.burden->mesh;
      moving.burden_radius_m = person.burden->half_size_m.head<2>().minCoeff();
      parts_.push_back(appended(mesh_, moving.burden));
      moving.burden_vertex = parts_.back().first_vertex;
      openness_.resize(mesh_.positions.size(), 1.0F);
      shade_balls_.resize(shade_balls_.size() + 1);
    }
    people_.push_back(std::move(moving));
  }
  move_to(nanoseconds{0});
}

MovingThings::~MovingThings() = default;
MovingThings::MovingThings(MovingThings&&) noexcept = default;
MovingThings& MovingThings::operator=(MovingThings&&) noexcept = default;

void MovingThings::move_to(nanoseconds scene_time) {
  if (scene_time_ == scene_time) return;
  scene_time_ = scene_time;
  const double time_s = speed_ * 1e-9 * static_cast<double>(scene_time.count());
  for (MovingPerson& moving : people_) {
    const Performance::Instant now = moving.performance.at(time_s);
    moving.skin.bend(now.pose, mesh_, moving.first_vertex);
    const float scale = moving.performance.measures().scale;
    ShadeBall* ball = &shade_balls_[moving.first_ball];
    for (const BallOnBone& on : kBalls)
      *ball++ = {now.pose.of(on.bone) * Vector3f(0, -scale * on.down_m, 0), scale * on.radius_m};
    for (const Bone foot : {Bone::kLeftFoot, Bone::kRightFoot})
      *ball++ = {now.pose.of(foot) * Vector3f(0, -0.04F * scale, 0.12F * scale), 0.05F * scale};
    if (moving.burden.positions.empty()) continue;
    place_rigid(moving.burden, now.world_from_burden, mesh_, moving.burden_vertex);
    *ball = {now.world_from_burden.translation(), moving.burden_radius_m};
  }
  for (MovingPart& part : parts_) {
    part.box_m.setEmpty();
    for (std::uint32_t i = 0; i < part.vertex_count; ++i)
      part.box_m.extend(mesh_.positions[part.first_vertex + i]);
  }
}

}  // namespace roomcast::simulator
