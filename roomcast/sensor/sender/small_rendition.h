// SPDX-License-Identifier: Apache-2.0
// SmallRendition: encodes a sensor's frames a second time, at a low rate of their own, for viewers
// whose lines do not carry the full rendition. Depth has a coarser step and colour at most the
// depth grid's size, so that every decoder takes both renditions. Single-threaded.
// Simulcast, as conferencing servers forward it (RFC 8853). docs/spec/wire.md §3 "Renditions".
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "roomcast/codec/frame_codec.h"
#include "roomcast/core/clock.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"
#include "roomcast/sensor/sender/rate_control.h"

namespace roomcast::sensor {

class SmallRendition {
 public:
  /// `full`: the options of the full rendition's encoder. `bytes_per_s`: as RateControl::Options.
  /// Errors: those of FrameEncoder::create.
  static Result<std::unique_ptr<SmallRendition>> create(codec::FrameEncoderOptions full,
                                                        double bytes_per_s);

  /// Appends the frame's payload to `out`; nothing: its rate allows no frame now. Pictures as in
  /// FrameEncoder::encode for the full rendition.
  Result<std::optional<codec::EncodedFrameInfo>> encode(DepthView depth_mm, ColorView color,
                                                        MaskView color_seen, HostTime capture_time,
                                                        bool want_key,
                                                        std::vector<std::uint8_t>& out);

  /// As FrameEncoder::set_base_only.
  void set_base_only(bool base_only) { encoder_->set_base_only(base_only); }
  /// Total of all payloads.
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }

 private:
  SmallRendition(std::unique_ptr<codec::FrameEncoder> encoder, const RateControl& rate,
                 int color_scale)
      : encoder_(std::move(encoder)), rate_(rate), color_scale_(color_scale) {}

  const std::unique_ptr<codec::FrameEncoder> encoder_;
  RateControl rate_;
  const int color_scale_;  // of the full rendition
  bool wants_key_ = true;  // also of a frame that the rate did not allow
  ColorImage color_;       // at half the size, where color_scale_ is 2
  std::uint64_t bytes_ = 0;
};

}  // namespace roomcast::sensor
