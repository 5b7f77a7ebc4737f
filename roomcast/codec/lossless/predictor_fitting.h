// SPDX-License-Identifier: Apache-2.0
// Chooses the predictors of a lossless depth frame: for each class of neighbourhoods least-squares
// weights, where they do better on this picture than the median. Looks at every eighth row. The
// encoder's choice alone: any weights decode.
#pragma once

#include "roomcast/codec/lossless/depth_model.h"
#include "roomcast/core/image.h"

namespace roomcast::codec {

/// `plane`: depth, or indices of a value table; 0 = no reading.
[[nodiscard]] Predictors fit_predictors(ImageView<const std::uint16_t> plane);

}  // namespace roomcast::codec
