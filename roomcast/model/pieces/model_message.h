// SPDX-License-Identifier: Apache-2.0
// The message by which a hub gives viewers the model of a room, or what has changed of it:
// docs/spec/model.md. Thread-safe (no state).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "roomcast/core/result.h"
#include "roomcast/model/room_volume.h"

namespace roomcast::model {

struct ModelMessage {
  bool is_whole = false;      // forget all pieces received before
  std::uint64_t version = 0;  // to be named when changes are asked for next
  struct Piece {
    GridPlace place;                      // of its cube
    std::span<const std::uint8_t> draco;  // empty: there is none there any more
  };
  std::vector<Piece> pieces = {};
};

[[nodiscard]] std::string write_model_message(const ModelMessage& message);

/// The pieces refer to `bytes`. kMalformed for anything else, kUnsupported for a later version.
[[nodiscard]] Result<ModelMessage> read_model_message(std::span<const std::uint8_t> bytes);

}  // namespace roomcast::model
