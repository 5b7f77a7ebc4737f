// SPDX-License-Identifier: Apache-2.0
// Decodes the depth section of a frame, of any codec. docs/spec/codec.md §2.
#pragma once

#include "roomcast/codec/live/live_depth_decoder.h"
#include "roomcast/codec/lossless/lossless_depth_decoder.h"
#include "roomcast/codec/payload/payload_sections.h"

namespace roomcast::codec {

class DepthSectionDecoder {
 public:
  /// Fills `depth_mm`, which must have the sensor's size. Returns the errors of the codecs'
  /// decoders.
  [[nodiscard]] Status decode(const PayloadSections& sections, ImageView<std::uint16_t> depth_mm) {
    switch (sections.depth_codec) {
      case kLosslessDepth:
        return intra_.decode(sections.depth, depth_mm);
      case kNearLosslessDepth:
        return intra_.decode_near_lossless(sections.depth, depth_mm);
      default:
        return live_.decode(sections.depth, depth_mm);
    }
  }

 private:
  LosslessDepthDecoder intra_;
  LiveDepthDecoder live_;
};

}  // namespace roomcast::codec
