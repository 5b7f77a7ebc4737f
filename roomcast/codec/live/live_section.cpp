// SPDX-License-Identifier: Apache-2.0
#include "roomcast/codec/live/live_section.h"

#include <algorithm>

#include "roomcast/core/little_endian.h"

namespace roomcast::codec {
namespace {

constexpr std::uint8_t kKeyFlag = 1, kReferenceFlag = 2;
constexpr std::size_t kHeadLength = 6;
constexpr std::size_t kKeyHeadLength = kHeadLength + 1 + kSigmaKnotCount;
constexpr std::uint8_t kMinStep = 4;  // so that a quarter of it is at least 1

Error cut_short() {
  return malformed("The live depth section is cut short.");
}

}  // namespace

Result<LiveSectionHead> read_live_head(std::span<const std::uint8_t>& bytes, std::uint32_t& hash) {
  if (bytes.size() < kHeadLength) return cut_short();
  LiveSectionHead head;
  head.key = bytes[0] & kKeyFlag;
  head.reference = bytes[0] & kReferenceFlag;
  if ((bytes[0] & ~(kKeyFlag | kReferenceFlag)) != 0) {
    return Error{ErrorCode::kUnsupported,
                 "The live depth is of a later version; update this program."};
  }
  head.step = bytes[1];
  hash = read_u32(bytes.data() + kLiveHashOffset);
  if (head.key) {
    if (bytes.size() < kKeyHeadLength) return cut_short();
    head.key_step = bytes[kHeadLength];
    std::copy_n(bytes.begin() + kHeadLength + 1, kSigmaKnotCount, head.sigma.begin());
  }
  if (head.step < kMinStep || (head.key && (!head.reference || head.key_step < kMinStep))) {
    return malformed("The head of the live depth section is damaged.");
  }
  bytes = bytes.subspan(head.key ? kKeyHeadLength : kHeadLength);
  return head;
}

void write_live_head(const LiveSectionHead& head, std::vector<std::uint8_t>& out) {
  out.push_back(
      static_cast<std::uint8_t>((head.key ? kKeyFlag : 0) | (head.reference ? kReferenceFlag : 0)));
  out.push_back(head.step);
  out.insert(out.end(), 4, 0);
  if (!head.key) return;
  out.push_back(head.key_step);
  out.insert(out.end(), head.sigma.begin(), head.sigma.end());
}

}  // namespace roomcast::codec
