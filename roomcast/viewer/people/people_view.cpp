// SPDX-License-Identifier: Apache-2.0
#include "roomcast/viewer/people/people_view.h"

#include <algorithm>
#include <utility>

namespace roomcast::viewer {

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
  bodies_.draw(eyes, avatars_.shown());
  if (own_) bodies_.draw_own(eyes, *own_, own_color_);
  labels_.draw(eyes, avatars_.shown());
}

}  // namespace roomcast::viewer
