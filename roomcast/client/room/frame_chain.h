// SPDX-License-Identifier: Apache-2.0
// FrameChain: decides whether a frame can be decoded, given the frames decoded before.
// docs/spec/wire.md §2, last paragraph. No I/O.
#pragma once

#include <cstdint>
#include <optional>

#include "roomcast/wire/frame_header.h"

namespace roomcast::client {

class FrameChain {
 public:
  [[nodiscard]] bool may_decode(const wire::FrameHeader& header) const {
    return header.key || (base_seq_ && *base_seq_ == header.base_seq);
  }
  void decoded(const wire::FrameHeader& header) {
    if (header.layer == 0) base_seq_ = header.seq;
  }
  /// Decoding failed: only a key frame can be decoded next.
  void broke() { base_seq_.reset(); }

 private:
  std::optional<std::uint32_t> base_seq_;  // the newest layer-0 frame that was decoded
};

}  // namespace roomcast::client
