// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/xr/headset_view.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace roomcast::viewer::xr {
namespace {

constexpr double kFarthestPointer_m = 8;
/// The surface at the pointer is found by drawing a few pixels from the hand's pose.
constexpr int kPointerPixels = 9;
constexpr double kPointerFov_rad = 0.02;

HostTime now() {
  return SteadyClock().now();
}

render::ViewCamera pointer_camera(const RigidTransform& world_from_aim) {
  render::ViewCamera camera;
  camera.width = camera.height = kPointerPixels;
  camera.vertical_fov_rad = kPointerFov_rad;
  camera.world_from_view = world_from_aim;
  return camera;
}

/// The largest angle between where the head points and what an eye sees. Eyes may look sideways.
double half_angle_of(const render::Eyes& eyes, const RigidTransform& world_from_head) {
  const Eigen::Vector3d ahead = -world_from_head.rotation.col(2);
  double widest = 0;
  for (const render::ViewCamera& eye : eyes) {
    const double cosine = ahead.dot(-eye.world_from_view.rotation.col(2));
    widest = std::max(
        widest, std::acos(std::clamp(cosine, -1.0, 1.0)) + render::view_angles(eye).half_angle_rad);
  }
  return std::min(widest, std::numbers::pi);
}

}  // namespace

Result<std::unique_ptr<HeadsetView>> HeadsetView::open() {
  auto headset = Headset::open();
  if (!headset) return headset.error();
  return std::unique_ptr<HeadsetView>(new HeadsetView(std::move(*headset)));
}

Status HeadsetView::draw(RoomView& room, const ViewSettings& settings, const ViewState& start,
                         const std::vector<Toast>& sentences) {
  headset_->see_through(settings.comfort.sees_through);
  const auto frame = headset_->begin_frame();
  if (!frame) return frame.error();
  is_seen_ = frame->is_seen;
  if (is_seen_) {
    move(frame->input, settings, start);
    Status drawn = find_pointed_at(room, frame->input.pointing_hand(settings.comfort));
    room.people().set_own(seen_of_self(frame->input, settings.comfort));
    if (drawn) drawn = draw_eyes(room, settings.mode);
    room.people().set_own(std::nullopt);
    if (drawn) drawn = headset_->tell(sentences);
    if (!drawn) {
      static_cast<void>(headset_->end_frame());  // a frame once begun must end
      return drawn;
    }
  }
  return headset_->end_frame();
}

void HeadsetView::move(const VrInput& input, const ViewSettings& settings, const ViewState& start) {
  const HostTime at = now();
  const std::chrono::duration<double> step = at - std::exchange(last_frame_, at);
  if (input.old_stage_from_stage) walk_.follow_stage(*input.old_stage_from_stage);
  if (!std::exchange(is_placed_, true) || input.recenters)
    walk_.stand_at(start, input.stage_from_head);
  walk_.advance(input, settings.comfort, step.count());
  const auto in_world = [&](const std::optional<RigidTransform>& stage_from_part) {
    return stage_from_part ? std::optional(walk_.world_from_stage() * *stage_from_part)
                           : std::nullopt;
  };
  pose_.world_from_head = walk_.world_from_stage() * input.stage_from_head;
  pose_.world_from_left_hand = in_world(input.left.stage_from_grip);
  pose_.world_from_right_hand = in_world(input.right.stage_from_grip);
}

Status HeadsetView::find_pointed_at(RoomView& room, const VrHand* pointing) {
  pose_.pointer.reset();
  if (pointing == nullptr || !pointing->stage_from_aim) return {};
  const RigidTransform world_from_aim = walk_.world_from_stage() * *pointing->stage_from_aim;
  const render::ViewCamera camera = pointer_camera(world_from_aim);
  if (auto status = pointed_at_.draw(room, camera, render::RenderMode::kMesh); !status)
    return status;
  const auto place_m =
      surface_at(*pointed_at_.target(), camera, kPointerPixels / 2, kPointerPixels / 2);
  pose_.pointer = client::PointerBeam{
      world_from_aim.translation_m,
      place_m.value_or(world_from_aim * Eigen::Vector3d(0, 0, -kFarthestPointer_m))};
  return {};
}

/// The wearer's hands and pointer or teleport beam.
client::PersonPose HeadsetView::seen_of_self(const VrInput& input,
                                             const ComfortOptions& comfort) const {
  client::PersonPose seen = pose_;
  if (const auto& target_m = walk_.teleport_target_m()) {
    const RigidTransform& from =
        input.main_hand(comfort).stage_from_aim.value_or(input.stage_from_head);
    seen.pointer = client::PointerBeam{(walk_.world_from_stage() * from).translation_m, *target_m};
  }
  return seen;
}

Status HeadsetView::draw_eyes(RoomView& room, render::RenderMode mode) {
  const render::Eyes in_stage = headset_->stage_eyes();
  const auto in_world = [this](render::ViewCamera camera) {
    camera.world_from_view = walk_.world_from_stage() * camera.world_from_view;
    return camera;
  };
  const render::Eyes eyes(in_world(in_stage[0]), in_world(in_stage[1]));
  pose_.view = {.half_angle_rad = half_angle_of(eyes, pose_.world_from_head)};
  if (auto status = picture_.draw(room, eyes, mode); !status) return status;
  headset_->show(*picture_.target());
  return {};
}

std::string HeadsetView::report() const {
  const FrameTiming& timing = headset_->timing();
  if (!is_seen()) return headset_->name() + ": not worn";
  return fmt::format("{}: {:.0f} Hz, {:.1f} ms a frame, {} of {} missed", headset_->name(),
                     timing.headset_per_s(),
                     std::chrono::duration<double, std::milli>(timing.ours()).count(),
                     timing.missed(), timing.frames());
}

}  // namespace roomcast::viewer::xr
