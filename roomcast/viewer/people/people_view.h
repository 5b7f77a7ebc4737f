// SPDX-License-Identifier: Apache-2.0
// PeopleView: draws the people of a room into the room's picture. Needs the GL context it was made
// with.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "roomcast/client/room/room_snapshot.h"
#include "roomcast/render/view/offscreen_target.h"
#include "roomcast/viewer/people/avatars.h"
#include "roomcast/viewer/people/body_renderer.h"
#include "roomcast/viewer/people/label_renderer.h"

namespace roomcast::viewer {

class PeopleView {
 public:
  /// kUnsupported with the driver's log if it rejects the shaders.
  static Result<PeopleView> create();

  void follow(const client::RoomSnapshot& room);
  /// True while anything still moves: draw again.
  bool advance(double seconds) { return avatars_.advance(seconds); }
  /// Sets this viewer's own hands and beam; empty: neither is drawn.
  void set_own(const std::optional<client::PersonPose>& own) { own_ = own; }
  [[nodiscard]] std::span<const Avatar> others() const { return avatars_.shown(); }

  /// Draws over the room in `target`. Somebody who stands where an eye is would fill the picture
  /// from within, and is not drawn.
  void draw(const render::Eyes& eyes, const render::OffscreenTarget& target);

 private:
  PeopleView(BodyRenderer bodies, LabelRenderer labels)
      : bodies_(std::move(bodies)), labels_(std::move(labels)) {}

  BodyRenderer bodies_;
  LabelRenderer labels_;
  /// Those who do not stand where an eye is.
  std::span<const Avatar> seen_by(const render::Eyes& eyes);

  Avatars avatars_;
  std::vector<Avatar> seen_;
  std::optional<client::PersonPose> own_;
  Rgb8 own_color_ = {255, 90, 60};
};

}  // namespace roomcast::viewer
