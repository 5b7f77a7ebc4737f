// SPDX-License-Identifier: Apache-2.0
// FrameSequence: numbers a sensor's frames within one session, and names the frame that each one
// builds on (docs/spec/wire.md §2, `seq` and `base_seq`). Pure.
#pragma once

#include <cstdint>
#include <optional>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/wire/frame_header.h"

namespace roomcast::client {

class FrameSequence {
 public:
  /// Numbers begin at 0 in each session.
  void enter(std::uint64_t session) {
    if (session != session_) *this = FrameSequence(session);
  }

  /// The header of the next frame, with its numbers only. Nothing: it builds on a key frame that
  /// was not sent in this session.
  [[nodiscard]] std::optional<wire::FrameHeader> next(const codec::EncodedFrameInfo& info) const {
    if (!info.key && !base_seq_) return std::nullopt;
    wire::FrameHeader header;
    header.key = info.key;
    header.layer = info.layer;
    header.seq = next_seq_;
    header.base_seq = info.key ? header.seq : *base_seq_;
    return header;
  }

  /// The frame with this header, from next(), is sent.
  void sent(const wire::FrameHeader& header) {
    ++next_seq_;
    if (header.layer == 0) base_seq_ = header.seq;
  }

  /// A frame of this session is skipped. It still gets a number, so that receivers can count it,
  /// unless none was sent before.
  void skip(std::uint64_t session) {
    if (session == session_ && base_seq_) ++next_seq_;
  }

  FrameSequence() = default;

 private:
  explicit FrameSequence(std::uint64_t session) : session_(session) {}

  std::uint64_t session_ = 0;
  std::uint32_t next_seq_ = 0;
  std::optional<std::uint32_t> base_seq_;
};

}  // namespace roomcast::client
