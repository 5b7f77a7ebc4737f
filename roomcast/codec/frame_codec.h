// SPDX-License-Identifier: Apache-2.0
// Encodes one sensor frame (depth, registered colour, colour mask) to one payload of the wire
// format and decodes it. docs/spec/codec.md. Depth and colour of one instant are one payload, so
// they arrive together or not at all. No I/O, no threads.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "roomcast/codec/payload/block_need.h"
#include "roomcast/codec/payload/encoder_options.h"
#include "roomcast/codec/payload/frame_quality.h"
#include "roomcast/core/image.h"
#include "roomcast/core/result.h"

namespace roomcast::codec {

struct EncodedFrameInfo {
  bool key = false;        // can be decoded alone
  std::uint8_t layer = 0;  // 0: later frames may need it; 1, 2: none do
  int quantizer = 0;       // the quality chosen for a target: FrameQuality; 0: there is none
};

class FrameEncoder {
 public:
  static Result<std::unique_ptr<FrameEncoder>> create(const FrameEncoderOptions& options);
  virtual ~FrameEncoder() = default;

  /// Appends the payload to `out`. `color` is in the depth grid, with color_scale times its
  /// resolution; `color_seen` has the size of depth. Colour is also sent where `color_seen` is not
  /// 0 and depth has no reading, but the mask there is 0. Both may be empty views (no colour in
  /// this frame). The first frame, and any with `want_key`, is a key frame.
  virtual Result<EncodedFrameInfo> encode(DepthView depth_mm, ColorView color, MaskView color_seen,
                                          bool want_key, std::vector<std::uint8_t>& out) = 0;

  /// Sets the colour stream's rate from the next frame on, clamped to the legal range of
  /// color_kbit_per_s. For rate adaptation to the network.
  virtual void set_color_rate(int kbit_per_s) = 0;

  /// Wanted sizes from the next frame on, in live mode; the colour stream's rate is then without
  /// effect. A single frame may be larger or smaller.
  virtual void set_target(const FrameTarget& target) = 0;

  /// From the next frame on: only frames of layer 0, or those of all layers again. The caller gives
  /// fewer frames meanwhile.
  virtual void set_base_only(bool base_only) = 0;

  /// As FrameEncoderOptions::key_interval_s, from the next frame on.
  virtual void set_key_interval(double seconds) = 0;

  /// Sets how much of each block viewers need, from the next frame on. `needs` has need_blocks() of
  /// the depth grid's width and height; empty: everything is needed. In live mode; other modes have
  /// everything in each frame. kInvalidArgument: another size.
  [[nodiscard]] virtual Status set_needs(BlockNeedsView needs) = 0;

  /// Depth of the newest frame as decoders will show it. Valid until the next call, and only as
  /// long as the encoded picture exists.
  [[nodiscard]] virtual DepthView decoded_depth() const = 0;
};

struct DecodedFrame {
  DepthImage depth_mm;   // as exact as the depth mode; in live mode, readings that vanish for a
                         // moment are kept
  ColorImage color;      // of the size of depth or twice that; empty if the frame has none
  MaskImage color_seen;  // of the size of depth: 255 where `color` is valid
};

class FrameDecoder {
 public:
  /// `width` x `height` as in the roster; a payload of another size is refused.
  static Result<std::unique_ptr<FrameDecoder>> create(int width, int height);
  virtual ~FrameDecoder() = default;

  /// kMalformed for hostile or damaged bytes, kUnsupported for sections or codecs of a later
  /// version; `out` is then unchanged or partly filled, and the next key frame recovers. Memory and
  /// time are bounded by the picture size.
  virtual Status decode(std::span<const std::uint8_t> payload, DecodedFrame& out) = 0;
};

}  // namespace roomcast::codec
