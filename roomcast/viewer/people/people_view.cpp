// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/people/people_view.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace roomcast::viewer {
namespace {

constexpr double kInTheEye_m = 0.25;  // a head is 0.13 m high and has a visor

}  // namespace

Result<PeopleView> PeopleView::create() {
  auto bodies = BodyRenderer::create();
  if (!bodies) return std::move(bodies).error();
  auto labels = LabelRenderer::create();
  if (!labels) return std::move(labels).error();
  return PeopleView(std::move(*bodies), std::move(*labels));
}

void PeopleView::follow(const client::RoomSnapshot& room) {
  avatars_.follow(room);
  const auto self = std::ranges::find(room.people, room.self, &client::RoomPerson::id);
  if (self != room.people.end()) own_color_ = self->color;
}

void PeopleView::draw(const render::Eyes& eyes, const render::OffscreenTarget& target) {
  target.bind();
  const render::EyeBorders borders(eyes);
  const std::span<const Avatar> seen = seen_by(eyes);
  bodies_.draw(eyes, seen);
  if (own_) bodies_.draw_own(eyes, *own_, own_color_);
  labels_.draw(eyes, seen);
}

std::span<const Avatar> PeopleView::seen_by(const render::Eyes& eyes) {
  const auto is_in_an_eye = [&](const Avatar& avatar) {
    return std::ranges::any_of(eyes, [&](const render::ViewCamera& eye) {
      const Eigen::Vector3d& head = avatar.shown.world_from_head.translation_m;
      return (head - eye.world_from_view.translation_m).norm() < kInTheEye_m;
    });
  };
  if (std::ranges::none_of(avatars_.shown(), is_in_an_eye)) return avatars_.shown();
  seen_.clear();
  std::ranges::remove_copy_if(avatars_.shown(), std::back_inserter(seen_), is_in_an_eye);
  return seen_;
}

}  // namespace roomcast::viewer
