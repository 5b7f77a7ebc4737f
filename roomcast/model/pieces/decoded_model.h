// SPDX-License-Identifier: Apache-2.0
// The model of a room as a viewer needs it: what the hub sends (model_message.h), with the pieces
// decoded. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/model/room_mesh.h"
#include "roomcast/model/room_volume.h"

namespace roomcast::model {

struct DecodedModel {
  bool is_whole = false;  // pieces received before are forgotten
  std::uint64_t version = 0;
  struct Piece {
    GridPlace place;
    RoomMesh mesh;  // without triangles: there is no piece there any more
  };
  std::vector<Piece> pieces = {};
};

/// Errors of read_model_message and decode_draco.
[[nodiscard]] Result<DecodedModel> decode_model(std::span<const std::uint8_t> bytes);

}  // namespace roomcast::model
