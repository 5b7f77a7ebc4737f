// SPDX-License-Identifier: Apache-2.0
// Chooses the predictors of a lossless depth frame: for each class of neighbourhoods, least-squares
// weights if they predict this picture better than the median. Reads every eighth row. Only the
// encoder chooses: any weights decode.
#pragma once

#include "roomcast/codec/lossless/depth_model.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

/// `plane`: depth, or indices of a value table; 0 = no reading.
[[nodiscard]] Predictors fit_predictors(ImageView<const std::uint16_t> plane);

}  // namespace roomcast::codec
