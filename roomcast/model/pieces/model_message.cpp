// SPDX-License-Identifier: Apache-2.0
#include "roomcast/model/pieces/model_message.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "roomcast/core/little_endian.h"

namespace roomcast::model {
namespace {

constexpr std::array<std::uint8_t, 3> kModelMagic = {'R', 'C', 'M'};
constexpr std::uint8_t kModelVersion = 1;
constexpr std::size_t kHeaderBytes = 20, kPieceHeaderBytes = 16;

Error not_a_model() {
  return {ErrorCode::kMalformed, "this is not the model of a room"};
}

void append_u32(std::uint32_t value, std::vector<std::uint8_t>& out) {
  out.resize(out.size() + sizeof(value));
  write_u32(out.data() + out.size() - sizeof(value), value);
}

}  // namespace

std::string write_model_message(const ModelMessage& message) {
  std::vector<std::uint8_t> out(kModelMagic.begin(), kModelMagic.end());
  out.push_back(kModelVersion);
  append_u32(message.is_whole ? 1 : 0, out);
  append_u32(static_cast<std::uint32_t>(message.version), out);
  append_u32(static_cast<std::uint32_t>(message.version >> 32U), out);
  append_u32(static_cast<std::uint32_t>(message.pieces.size()), out);
  for (const ModelMessage::Piece& piece : message.pieces) {
    for (const std::int32_t axis : {piece.place.x, piece.place.y, piece.place.z})
      append_u32(static_cast<std::uint32_t>(axis), out);
    append_u32(static_cast<std::uint32_t>(piece.draco.size()), out);
    out.insert(out.end(), piece.draco.begin(), piece.draco.end());
  }
  return {out.begin(), out.end()};
}

Result<ModelMessage> read_model_message(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHeaderBytes || !std::ranges::equal(bytes.first(3), kModelMagic))
    return not_a_model();
  if (bytes[3] != kModelVersion)
    return Error{ErrorCode::kUnsupported, "this model is of another version of roomcast"};
  ModelMessage message;
  message.is_whole = (bytes[4] & 1U) != 0;
  message.version = read_u64(&bytes[8]);
  const std::uint32_t count = read_u32(&bytes[16]);
  std::size_t at = kHeaderBytes;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (bytes.size() - at < kPieceHeaderBytes) return not_a_model();
    const auto axis = [&](std::size_t n) {
      return static_cast<std::int32_t>(read_u32(&bytes[at + 4 * n]));
    };
    const std::size_t length = read_u32(&bytes[at + 12]);
    const GridPlace place{axis(0), axis(1), axis(2)};
    at += kPieceHeaderBytes;
    if (bytes.size() - at < length) return not_a_model();
    message.pieces.push_back({place, bytes.subspan(at, length)});
    at += length;
  }
  if (at != bytes.size()) return not_a_model();
  return message;
}

}  // namespace roomcast::model
