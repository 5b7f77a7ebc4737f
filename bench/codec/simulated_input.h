// SPDX-License-Identifier: Apache-2.0
// The simulator as an input of `roomcast bench codec`. Frame i is the instant i / fps, as in
// `roomcast simulate`.
#pragma once

#include "bench/codec/bench_input.h"

namespace roomcast::bench {

/// `source` is sim[:scene][#n].
[[nodiscard]] Result<std::unique_ptr<BenchInput>> open_simulated_input(
    const std::string& source, const BenchInputOptions& options);

}  // namespace roomcast::bench
