// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/pieces/decoded_model.h"

#include <utility>

#include "roomcast/model/pieces/draco_mesh.h"
#include "roomcast/model/pieces/model_message.h"

namespace roomcast::model {

Result<DecodedModel> decode_model(std::span<const std::uint8_t> bytes) {
  const auto message = read_model_message(bytes);
  if (!message) return message.error();
  DecodedModel decoded{message->is_whole, message->version, {}};
  for (const ModelMessage::Piece& piece : message->pieces) {
    if (piece.draco.empty()) {
      decoded.pieces.push_back({piece.place, {}});
      continue;
    }
    auto mesh = decode_draco(piece.draco);
    if (!mesh) return mesh.error();
    decoded.pieces.push_back({piece.place, *std::move(mesh)});
  }
  return decoded;
}

}  // namespace roomcast::model
