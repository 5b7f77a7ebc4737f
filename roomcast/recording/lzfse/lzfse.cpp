// SPDX-License-Identifier: Apache-2.0
#include "roomcast/recording/lzfse/lzfse.h"

#include "roomcast/core/little_endian.h"
#include "roomcast/recording/lzfse/entropy_block.h"
#include "roomcast/recording/lzfse/lzvn.h"

namespace roomcast::recording {
namespace {

constexpr std::uint32_t kEndBlock = 0x24787662;       // "bvx$"
constexpr std::uint32_t kPlainBlock = 0x2D787662;     // "bvx-"
constexpr std::uint32_t kLzvnBlock = 0x6E787662;      // "bvxn"
constexpr std::uint32_t kEntropyBlock1 = 0x31787662;  // "bvx1"
constexpr std::uint32_t kEntropyBlock2 = 0x32787662;  // "bvx2"
constexpr std::size_t kPlainHeadBytes = 8, kLzvnHeadBytes = 12;

std::optional<std::size_t> decode_plain_block(std::span<const std::uint8_t> bytes, LzOutput& out) {
  if (bytes.size() < kPlainHeadBytes) return std::nullopt;
  const std::size_t size = read_u32(bytes.data() + 4);
  if (bytes.size() - kPlainHeadBytes < size || !out.append(bytes.subspan(kPlainHeadBytes, size)))
    return std::nullopt;
  return kPlainHeadBytes + size;
}

std::optional<std::size_t> decode_lzvn_block(std::span<const std::uint8_t> bytes, LzOutput& out) {
  if (bytes.size() < kLzvnHeadBytes) return std::nullopt;
  const std::size_t raw = read_u32(bytes.data() + 4), payload = read_u32(bytes.data() + 8);
  const std::size_t begin = out.size();
  if (bytes.size() - kLzvnHeadBytes < payload || raw > out.left() ||
      !decode_lzvn(bytes.subspan(kLzvnHeadBytes, payload), out) || out.size() - begin != raw)
    return std::nullopt;
  return kLzvnHeadBytes + payload;
}

std::optional<std::size_t> decode_block(std::span<const std::uint8_t> bytes, LzOutput& out) {
  switch (read_u32(bytes.data())) {
    case kPlainBlock:
      return decode_plain_block(bytes, out);
    case kLzvnBlock:
      return decode_lzvn_block(bytes, out);
    case kEntropyBlock1:
    case kEntropyBlock2:
      return decode_entropy_block(bytes, out);
    default:
      return std::nullopt;
  }
}

}  // namespace

bool decode_lzfse(std::span<const std::uint8_t> bytes, std::size_t size,
                  std::vector<std::uint8_t>& out) {
  LzOutput decoded(out, size);
  while (bytes.size() >= 4 && read_u32(bytes.data()) != kEndBlock) {
    const auto used = decode_block(bytes, decoded);
    if (!used) return false;
    bytes = bytes.subspan(*used);
  }
  return bytes.size() >= 4 && decoded.size() == size;
}

}  // namespace roomcast::recording
