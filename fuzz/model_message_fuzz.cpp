// SPDX-License-Identifier: Apache-2.0
// Reads an untrusted model of a room: any bytes are refused, or are those that the message that was
// read of them is written as.
#include <cstddef>
#include <cstdint>
#include <string>

#include "roomcast/model/pieces/model_message.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace roomcast::model;
  const auto message = read_model_message({data, size});
  if (!message) return 0;
  std::size_t total = 0;
  for (const ModelMessage::Piece& piece : message->pieces) total += piece.draco.size();
  if (total > size) __builtin_trap();
  const std::string again = write_model_message(*message);
  const auto back =
      read_model_message({reinterpret_cast<const std::uint8_t*>(again.data()), again.size()});
  if (!back || back->version != message->version || back->is_whole != message->is_whole ||
      back->pieces.size() != message->pieces.size())
    __builtin_trap();
  return 0;
}
