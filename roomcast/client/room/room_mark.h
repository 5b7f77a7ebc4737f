// SPDX-License-Identifier: Apache-2.0
// RoomMark: what a person leaves in the room for everybody, and the list of all of a room, built
// from the hub's messages (docs/spec/wire.md section 3). World frame, metres. Single-threaded.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/wire/control.pb.h"

namespace roomcast::client {

enum class MarkKind : std::uint8_t {
  kNote = 1,  // words at a point
  kSketch,    // a line along surfaces
  kDistance,  // between two points
  kPlace,     // a name and two points: where somebody stands, and what they look at
};

struct RoomMark {
  std::uint32_t id = 0;  // by the hub, as author and color
  MarkKind kind = MarkKind::kNote;
  std::vector<Eigen::Vector3f> points_m;
  std::string text;
  std::string author;
  Rgb8 color{};
  bool own = false;  // this viewer may remove it without an admin's token
};

/// kMalformed or kTooLarge: no hub takes this mark.
[[nodiscard]] Result<wire::pb::Mark> message_from_mark(const RoomMark& mark);

class RoomMarks {
 public:
  using List = std::vector<RoomMark>;

  /// On joining: forgets all. `author_tag` is that of this viewer's marks; 0: it has none.
  void join(std::uint64_t author_tag);
  /// Leaves out kinds of a later version.
  void take(const wire::pb::Marks& message);

  /// By ID, which is the order in which they were left. Never null; unchanged marks are the same
  /// object.
  [[nodiscard]] const std::shared_ptr<const List>& all() const { return all_; }

 private:
  std::uint64_t author_tag_ = 0;
  std::shared_ptr<const List> all_ = std::make_shared<const List>();
};

}  // namespace roomcast::client
