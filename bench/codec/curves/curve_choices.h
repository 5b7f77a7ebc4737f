// SPDX-License-Identifier: Apache-2.0
// The codecs of `roomcast bench codec --curves`: each way of sending depth or colour at several
// qualities, so that it is a curve of error over bytes.
#pragma once

#include <vector>

#include "bench/codec/codec_choice.h"

namespace roomcast::bench {

/// In the order of the curves' names in the chart; choices of one curve have the same `curve`.
[[nodiscard]] std::vector<CodecChoice> curve_choices();

}  // namespace roomcast::bench
