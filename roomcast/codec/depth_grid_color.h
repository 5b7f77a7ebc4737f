// SPDX-License-Identifier: Apache-2.0
// Colour with one pixel for each pixel of depth, for those to whom finer colour is of no use: point
// clouds, files of others.
#pragma once

#include <memory>

#include "roomcast/codec/frame_codec.h"

namespace roomcast::codec {

/// Where colour is twice as fine as depth, the mean of each four pixels; else a copy.
[[nodiscard]] ColorImage color_in_depth_grid(ColorView color, int width, int height);

/// The same frame where its colour is in the depth grid or absent; else a copy of which it is.
[[nodiscard]] std::shared_ptr<const DecodedFrame> with_color_in_depth_grid(
    std::shared_ptr<const DecodedFrame> frame);

}  // namespace roomcast::codec
