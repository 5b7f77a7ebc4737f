// SPDX-License-Identifier: Apache-2.0
// Reduces colour to one pixel for each depth pixel, for consumers without a use for finer colour:
// point clouds, exports to other file formats.
#pragma once

#include <memory>

#include "roomcast/codec/frame_codec.h"

namespace roomcast::codec {

/// The mean of each 2x2 pixels where colour has twice the resolution of depth; else a copy.
[[nodiscard]] ColorImage color_in_depth_grid(ColorView color, int width, int height);

/// Returns `frame` itself if its colour is in the depth grid or absent; else a copy with reduced
/// colour.
[[nodiscard]] std::shared_ptr<const DecodedFrame> with_color_in_depth_grid(
    std::shared_ptr<const DecodedFrame> frame);

}  // namespace roomcast::codec
