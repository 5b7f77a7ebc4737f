// SPDX-License-Identifier: Apache-2.0
// Avatars: the other people of a room, animated between the poses received from the hub. Poses
// arrive 20 times a second; heads, hands and beams glide to the newest one, as on the page
// (web/src/view/avatars.ts). Pure, single-threaded.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "roomcast/client/room/room_snapshot.h"

namespace roomcast::viewer {

struct Avatar {
  ViewerId id{};
  std::string name;  // never empty
  Rgb8 color;
  client::PersonPose shown;
};

class Avatars {
 public:
  /// Takes over everyone except this viewer. People without a pose are not shown.
  void follow(const client::RoomSnapshot& room);

  /// True while anything still moves: draw again.
  bool advance(double seconds);

  [[nodiscard]] std::span<const Avatar> shown() const { return shown_; }

 private:
  std::vector<Avatar> shown_;
  std::vector<client::PersonPose> wanted_;  // newest pose of each
};

}  // namespace roomcast::viewer
