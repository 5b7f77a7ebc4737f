// SPDX-License-Identifier: Apache-2.0
// An input as a sensor in live mode sends it: without what the infrared light of other cameras does
// to depth (roomcast/sensor/interference_filter.h).
#pragma once

#include <memory>

#include "bench/codec/bench_input.h"

namespace roomcast::bench {

/// Filters the depth of each frame; truth stays as it is.
[[nodiscard]] std::unique_ptr<BenchInput> without_interference(std::unique_ptr<BenchInput> input);

}  // namespace roomcast::bench
